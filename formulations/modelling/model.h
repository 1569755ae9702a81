#pragma once

#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/mechanism.h"
#include "formulations/modelling/groups/idle_freedoms.h"
#include "formulations/modelling/independence/independence.h"

namespace desmo {

/// A mechanism modelled from its description, and what the user should know of it.
struct Model {
  Mechanism mechanism;
  std::vector<LeftOut> left_out;    ///< candidate equations that follow from others
  std::vector<IdleFreedom> idle{};  ///< freedoms that move nothing that is modelled
};

/// Models a description: rigid bodies, structural groups, coordinates, independent equations.
/// motions: one for each driven coordinate, in the description's order. Throws
/// std::invalid_argument, naming the place, for a description that is not valid (see validate) or
/// is not a mechanism that its drivers determine.
Model model(const Description& description, const std::vector<Motion>& motions);

/// The whole mechanism of a scene, whatever the scene asks for.
Mechanism make_mechanism(const Scene& scene);

}  // namespace desmo
