#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/level.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/motion.h"

namespace desmo {

/// A requested entity, and the highest level requested of it.
struct RequestedEntity {
  enum class Kind { point, vector, coordinate };
  Kind kind;
  int index;  ///< index in the mechanism's points, vectors or coordinates
  Level level;
};

/// A requested function of the coordinates' values and rates, which is no coordinate itself.
struct RequestedMeasure {
  enum class Kind {
    rotation,  ///< of a body: its rotation from the drawing, angular velocity and acceleration
    joint,     ///< turn about the axis, or travel along it, of the second body in the first
    ratio,     ///< of two rates
  };
  Kind kind;
  int index;                        ///< in the mechanism's bodies or joints
  Level level;                      ///< highest level requested; of a ratio: velocity
  std::string name{};               ///< of a ratio
  std::array<std::string, 2> of{};  ///< a ratio's coordinates, as Model::coordinate() knows them
  bool by_pattern = false;          ///< only patterns ask for it, if there is one
};

/// Default limit of ‖Φ‖₂ of the whole model, each equation divided by its natural magnitude.
inline constexpr double default_tolerance = 1e-12;

/// An analysis to be done: a mechanism, its drivers' motions, the instants and the request.
///
///   Scene scene = library_scene("slider_crank");
///   scene.motions = {Polynomial{{0, 2}}};         // 2 rad/s
///   scene.grid = {.step = 1e-3, .instants = 1001};
struct Scene {
  std::string name;  ///< one line, for people
  Mechanism mechanism;
  std::vector<Motion> motions;  ///< one for each driven coordinate, in the mechanism's order
  TimeGrid grid;                ///< instants to solve
  /// Requested entities, without duplicates; empty, without measures: everything, at the level of
  /// acceleration.
  std::vector<RequestedEntity> request{};
  std::string formulation{};                 ///< id; empty: the program chooses
  double tolerance = default_tolerance;      ///< Settings::tolerance
  std::vector<RequestedMeasure> measures{};  ///< requested as well, without duplicates
  /// Patterns that ask for measures of a kind; each must give one.
  std::set<std::pair<RequestedMeasure::Kind, std::string>> patterns{};

  bool asks_for_everything() const { return request.empty() && measures.empty(); }
};

}  // namespace desmo
