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
  int index;    ///< index in the mechanism's points, vectors or coordinates
  Level level;  ///< highest level requested
};

/// A requested quantity that is no coordinate. It is computed from coordinates and their rates.
struct RequestedMeasure {
  enum class Kind {
    rotation,  ///< a body's rotation from the drawing, angular velocity and angular acceleration
    joint,     ///< motion of a joint's second body in its first: angle about the axis, travel along
               ///< it, or both
    ratio,     ///< ratio of the velocities of two coordinates
  };
  Kind kind;
  int index;                        ///< index in the mechanism's bodies or joints; ratio: none
  Level level;                      ///< highest level requested; ratio: velocity
  std::string name{};               ///< name of a ratio; else empty
  std::array<std::string, 2> of{};  ///< a ratio's coordinates, as Model::coordinate() knows them
  /// Only patterns ask for it, no name. An angle is then left out where the points and vectors of a
  /// body do not determine how the body turns. An angle asked for by name would be refused.
  bool by_pattern = false;
};

/// Default of Settings::tolerance, the limit of ‖Φ‖₂ of the whole model; relative, since each
/// equation is divided by its natural magnitude.
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
  /// Requested entities, without duplicates. When these and `measures` are empty, everything is
  /// requested, up to accelerations.
  std::vector<RequestedEntity> request{};
  std::string formulation{};                 ///< id of a formulation; empty: the program chooses
  double tolerance = default_tolerance;      ///< Settings::tolerance
  std::vector<RequestedMeasure> measures{};  ///< requested measures, without duplicates
  /// Patterns that ask for measures, with their kind. Modelling refuses one that gives no measure.
  std::set<std::pair<RequestedMeasure::Kind, std::string>> patterns{};

  bool asks_for_everything() const { return request.empty() && measures.empty(); }
};

}  // namespace desmo
