#pragma once

#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"
#include "formulations/modelling/groups/idle_freedoms.h"
#include "formulations/modelling/independence/independence.h"

namespace desmo {

/// A model of a mechanism, with remarks for the user.
struct ModellingResult {
  Model model;
  std::vector<LeftOut> left_out;    ///< candidate equations that follow from others
  std::vector<IdleFreedom> idle{};  ///< freedoms that move no modelled point or vector
};

/// Models a mechanism: finds rigid bodies, structural groups, coordinates and independent
/// equations. motions: one per driven coordinate, in the mechanism's order. Throws
/// std::invalid_argument, naming the place, for an invalid mechanism (see validate) or one that its
/// drivers do not determine.
ModellingResult model_mechanism(const Mechanism& mechanism, const std::vector<Motion>& motions);

/// Models the whole mechanism of a scene, independent of what the scene requests.
Model make_model(const Scene& scene);

}  // namespace desmo
