#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/misfit.h"
#include "formulations/model/model.h"

namespace desmo {

/// A candidate equation that was left out: it follows from others, or is between points and vectors
/// of the ground.
struct LeftOut {
  std::string equation;                   ///< name of the constraint
  std::vector<int> rows;                  ///< rows of the constraint that were left out
  GroupId group;                          ///< group of the equation
  std::vector<std::string> follows_from;  ///< names of the constraints that imply it
  bool redundant;  ///< the group has more restrictions than freedoms, not just more equations
  std::optional<Misfit> misfit{};  ///< largest of its rows; only of an equation of the ground
};

/// An idle freedom: a motion of a body that moves none of its points and vectors. An example is the
/// spin of a coupler about the line of its two spherical joints. No coordinate models it.
struct IdleFreedom {
  std::string body;   ///< name of the rigid body's first body
  std::string about;  ///< centre or axis of the spin: "the line of 'A' and 'B'"

  bool operator==(const IdleFreedom&) const = default;
};

/// A model of a mechanism, with remarks for the user.
struct ModellingResult {
  Model model;
  std::vector<LeftOut> left_out;    ///< candidate equations with rows that are not solved
  std::vector<IdleFreedom> idle{};  ///< freedoms that move no modelled point or vector
};

/// Models a mechanism: finds rigid bodies, structural groups, coordinates and independent
/// equations; says what it left out.
/// - motions: one per driven coordinate, in the mechanism's order
/// - modelling: the kind of coordinates
/// Throws std::invalid_argument, naming the place, for an invalid mechanism (see validate) or one
/// that its drivers do not determine.
ModellingResult model_mechanism(const Mechanism& mechanism, const std::vector<Motion>& motions,
                                Modelling modelling = Modelling::natural);

/// Returns the model alone of a scene's whole mechanism, independent of what the scene requests.
///
///   const Model model = make_model(library_scene("slider_crank"));
///   const int x = model.coordinate("C.x");  // position of that coordinate in q
Model make_model(const Scene& scene, Modelling modelling = Modelling::natural);

}  // namespace desmo
