#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/level.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/motion.h"

namespace desmo {

/// One thing that a scene asks for.
struct Wanted {
  enum class Kind { point, vector, coordinate };
  Kind kind;
  int index;  ///< in the description's points, vectors or coordinates
  Level level;
};

/// On ‖Φ‖₂ of a whole mechanism, each equation divided by its natural magnitude, wherever nobody
/// asks for another: in scenes, in settings, in benchmarks.
inline constexpr double default_tolerance = 1e-12;

/// What is to be solved: a mechanism, how it is driven, when, and what is asked.
///
///   Scene scene = library_scene("slider_crank");
///   scene.motions = {Polynomial{{0, 2}}};         // 2 rad/s
///   scene.grid = {.step = 1e-3, .instants = 1001};
struct Scene {
  std::string name;
  Mechanism mechanism;
  std::vector<Motion> motions;  ///< one for each driven coordinate, in the description's order
  TimeGrid grid;
  /// Nothing twice; empty: everything, at the level of acceleration.
  std::vector<Wanted> request;
  std::string formulation;  ///< id; empty: the program's choice
  double tolerance = default_tolerance;
};

}  // namespace desmo
