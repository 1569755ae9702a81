#pragma once

#include <cstdint>
#include <string>

#include "cases/mechanism/scene.h"
#include "formulations/model/plan.h"
#include "formulations/verification/run/check_options.h"
#include "tests/properties/truth.h"

namespace desmo::properties {

/// A scene that was drawn, with its answers.
struct DrawnScene {
  int number = 0;
  std::string kind, family;
  std::string aim;        ///< "random", or "pass 1e-08": kind and distance to a singular position
  std::string text = {};  ///< scene file
  Scene scene = {};       ///< read from the text
  CheckMode mode = CheckMode::proof;
  Model whole = {};
  Plan plan = {};    ///< coordinates and levels that are solved
  Truth truth = {};  ///< right answers of the plan's model
};

/// Draws a scene. The same seed and number give the same scene. Throws std::runtime_error where no
/// draw serves.
DrawnScene draw_scene(std::uint64_t seed, int number);

/// Completes a scene from its text: reads it, models it and finds its answers.
void read_drawn_scene(DrawnScene& scene);

}  // namespace desmo::properties
