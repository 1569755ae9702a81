#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"

namespace desmo {

/// A candidate equation that was left out because it follows from others.
struct LeftOut {
  std::string equation;                   ///< name of the constraint
  std::vector<int> rows;                  ///< its scalar equations concerned
  GroupId group;                          ///< whose equation it would have been
  std::vector<std::string> follows_from;  ///< constraints
  bool redundant;  ///< the group has more restrictions than freedoms, not just more equations
};

/// A freedom of a body that moves none of its points and vectors: of a coupler between two
/// spherical joints, the spin about their line. Nothing depends on it and no coordinate models it.
struct IdleFreedom {
  std::string body;   ///< the first of those that are rigidly joined
  std::string about;  ///< what it is free to spin about: "the line of 'A' and 'B'"

  bool operator==(const IdleFreedom&) const = default;
};

/// A model of a mechanism, and what the user should know of it.
struct ModellingResult {
  Model model;
  std::vector<LeftOut> left_out;    ///< candidate equations that follow from others
  std::vector<IdleFreedom> idle{};  ///< freedoms that move nothing that is modelled
};

/// Models a mechanism: rigid bodies, structural groups, coordinates, independent equations.
/// motions: one for each driven coordinate, in the mechanism's order. Throws
/// std::invalid_argument, naming the place, for a mechanism that is not valid (see validate) or
/// is not determined by its drivers.
ModellingResult model_mechanism(const Mechanism& mechanism, const std::vector<Motion>& motions);

/// Returns the model of the whole mechanism of a scene, whatever the scene asks for.
///
///   const Model model = make_model(library_scene("slider_crank"));
///   const int x = model.entities[model.find("C")].first;  // of C in q
Model make_model(const Scene& scene);

}  // namespace desmo
