#pragma once

#include <map>
#include <optional>
#include <string>

#include "tests/checked/rows.h"
#include "tests/properties/drawn_scene.h"

namespace desmo::properties {

/// A number that breaks the promise.
struct Finding {
  std::string what;        ///< "outside its radius", "no answer", …
  std::string coordinate;  ///< name of the coordinate; empty: of the row
  Level level = Level::position;
  double time = 0;               ///< [s]
  double error = 0, radius = 0;  ///< in the unit of the coordinate
  double condition = 0;          ///< true one of the instant
};

/// Verdict on a run.
struct Judgement {
  std::optional<Finding> wrong{};  ///< the worst number that breaks the promise
  long rows = 0;                   ///< instants of the grid
  long regular = 0;                ///< instants to which a well-conditioned way leads
  /// Flags and missing rows by their words, of all instants and of regular ones.
  std::map<std::string, long> flags{}, regular_flags{};
  std::optional<RowFlag> first_regular_flag{};  ///< the first of these
  double condition = 0;  ///< largest true one on the way to its row since the instant before
};

/// Judges a run:
/// - without a flag, and passing a change point, every coordinate that is requested is within its
///   radius of the answer at every level, which exists
/// - without a flag no equation that was left out fails by more than what rounding each number of
///   the file explains; one that holds to a rounding is not called a misfit
/// - with any other flag positions are finite numbers.
Judgement judge(const DrawnScene& scene, const CheckedRows& run);

/// Solves a scene in a formulation as `desmo solve` does. Null: it is not offered with these
/// settings.
std::optional<CheckedRows> solve_checked(const DrawnScene& scene, const std::string& id);

}  // namespace desmo::properties
