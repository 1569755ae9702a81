#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"
#include "formulations/verification/reference/continuation.h"

namespace desmo::promise {

/// A scene that was drawn, with its answers.
struct DrawnScene {
  int number;
  std::string family;
  std::string aim;        ///< "random", or "pass 1e-08": kind and distance to a singular position
  std::string text = {};  ///< scene file
  Scene scene = {};       ///< read from the text
  Model model = {};
  std::vector<TrueInstant> truth = {};  ///< (instants)
  /// (instants) Answers of other equations of an overconstrained mechanism; no q: there are none.
  std::vector<ReferenceInstant> other_answers = {};
  /// Magnitude of coordinates over the mechanism's size, times that of the drivers, at least 1:
  /// rounding grows with it.
  double rounding = 1;
  /// The mechanism is overconstrained. Where its independent equations are singular, all of them
  /// need not be, so that nothing is known there.
  bool overconstrained = false;
};

/// Draws a scene; odd numbers are aimed. The same seed and number give the same scene.
DrawnScene draw_scene(std::uint64_t seed, int number);

/// Returns a mechanism's scene as text of a scene file. motions: JSON, by name of the driver.
std::string scene_text(const Mechanism& mechanism, const std::string& name,
                       const std::string& motions, const TimeGrid& grid, bool degrees);

}  // namespace desmo::promise
