// A timed item of a record: what it is of, whether its answer is right, its times. Plain data.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

/// A case at a size.
struct CaseSize {
  std::string case_name;
  std::int64_t coordinates = 0;
  /// Returns whether it is of the same case and size; derived keys compare these alone.
  bool is_at(const CaseSize& place) const { return *this == place; }
  auto operator<=>(const CaseSize&) const = default;
};

/// The clock of a time. Times of two clocks share neither a column nor a ratio.
enum class Clock {
  cpu,   ///< CPU seconds of one thread
  wall,  ///< seconds that passed: where several threads work, and for what is compared with them
};

/// Times of the equal timing windows, pieces between two clock readings, into which a motion is
/// cut. Each vector has one value a window, or is empty where the record has none.
struct Windows {
  std::vector<double> least = {};  ///< seconds: the least that any analysis took
  // The following are empty where updates are not counted.
  std::vector<double> instants = {};              ///< number of instants
  std::vector<double> updates = {};               ///< updates of unknowns by Newton's method
  std::vector<std::vector<double>> samples = {};  ///< seconds, by analysis
};

/// Samples of a time, by one clock.
struct Time {
  Clock clock = Clock::cpu;
  std::vector<double> seconds;  ///< one per repetition
  Windows windows;              ///< as many as the record's settings say; one by the wall clock
};

/// Tells whether a formulation of this id, with settings, is measured by the wall clock.
inline bool is_by_wall(std::string_view id) {
  return id.find("/threads:") != id.npos || id.find("/clock:wall") != id.npos;
}

enum class Status { ok, failed, not_run, not_applicable };

/// A value for each level.
template <class Value>
struct PerLevel {
  Value position = {}, velocity = {}, acceleration = {};
};
using LevelNumbers = PerLevel<double>;

/// The origin of a time. Digests are SHA-256.
struct Origin {
  std::optional<std::string> machine;  ///< CPU that it was measured on
  std::optional<std::string> model;    ///< digest of the mechanism
  std::optional<std::string> results;  ///< digest of the answers, rounded to what is allowed
};

/// Something that was to be timed: an analysis, or a step of one.
struct Measurement {
  Status status = Status::not_run;
  std::string message;  ///< why it has no time
  Origin origin = {};
  Time time = {};  ///< has samples when ok only
  /// Largest absolute differences from the reference.
  std::optional<LevelNumbers> verification = {};
  std::optional<double> setup_seconds = {};
  std::optional<double> iterations_per_step = {};
};

}  // namespace desmo::report
