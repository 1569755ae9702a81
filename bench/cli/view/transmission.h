// Transmission angles of four-bar loops.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/mechanism/mechanism.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// A loop of four bodies and four revolute joints in the plane, one of them the ground: an input
/// joined to the ground turns a follower joined to the ground, through a coupler.
struct FourBarLoop {
  std::string input, coupler, follower;  ///< bodies
  int b, c, d;                           ///< points: input–coupler, coupler–follower, pivot
};

/// Returns the loops whose input is driven, or is solved before coupler and follower.
/// group: of each body, −1 for the ground.
std::vector<FourBarLoop> four_bar_loops(const Mechanism& mechanism, std::span<const GroupId> group);

/// Returns the angle between coupler and follower, at most 90° [°]. state: positions, (q).
double transmission_angle(const FourBarLoop& loop, const Mechanism& mechanism, const Model& model,
                          std::span<const double> state);

}  // namespace desmo::cli
