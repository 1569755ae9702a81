#pragma once

#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"
#include "formulations/modelling/groups/idle_freedoms.h"
#include "formulations/modelling/independence/independence.h"

namespace desmo {

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
Model make_model(const Scene& scene);

}  // namespace desmo
