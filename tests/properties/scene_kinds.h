#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/motion.h"
#include "formulations/verification/run/check_options.h"
#include "tests/properties/mechanisms.h"
#include "tests/properties/motions.h"
#include "tests/properties/path_range.h"

namespace desmo::properties {

/// Parts of a scene file.
struct Draft {
  std::string family, aim;
  Mechanism mechanism;
  std::vector<std::string> motions;  ///< JSON of each driver
  TimeGrid grid;
  bool degrees = false;      ///< unit of angles; else radians
  std::string request = {};  ///< JSON; empty: everything
  CheckMode mode = CheckMode::proof;
};

/// A kind of scene, and the function that draws one. It throws std::exception where its numbers
/// make none.
struct SceneKind {
  std::string_view name;
  Draft (*draw)(Random&);
};

/// Returns all kinds. A new one is a function below, and a line in this one's table.
std::span<const SceneKind> scene_kinds();

// Kinds of scenes, all at random sizes and places.
Draft draw_random(Random& random);         ///< motions between singular positions
Draft draw_aimed(Random& random);          ///< an instant 0 to 0.1 from a singular position
Draft draw_requested(Random& random);      ///< some entities at some levels are requested
Draft draw_far_start(Random& random);      ///< begins up to two turns from the drawing
Draft draw_coupled(Random& random);        ///< coordinates are coupled
Draft draw_rough(Random& random);          ///< points are drawn up to 10 % off their places
Draft draw_decimal(Random& random);        ///< lengths and places have few decimals
Draft draw_contradicting(Random& random);  ///< a crank of three is longer by 1e-16 to 1e-5
Draft draw_typed(Random& random);          ///< overconstrained, typed with 3 to 17 digits

/// A mechanism, and the way of its drivers.
struct DrawnPath {
  Drawn drawn;
  PathRange range;
  int coordinates;
};

/// Finds the way of a mechanism's drivers, from what its drawing means. Throws std::exception where
/// that is no position.
DrawnPath path_of(Drawn drawn);

/// Returns the draft of a motion along a path, whose base is these values of the drivers.
Draft draft_of(Random& random, std::string_view family, const DrawnPath& path,
               const std::vector<double>& base, const Profile& profile);

/// Returns the draft of a random motion between singular positions.
Draft draft_inside(Random& random, std::string_view family, const DrawnPath& path);

/// Rounds all numbers of a mechanism to so many digits.
void round_numbers(Mechanism& mechanism, int digits);

}  // namespace desmo::properties
