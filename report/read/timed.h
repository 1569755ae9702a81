// A measurement of a record: what was measured, whether its answer is right, its times. Plain data.
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
  std::int64_t coordinates = 0;  ///< size: number of coordinates
  /// Returns whether case and size are the same. Other members of derived keys are not compared.
  bool is_at(const CaseSize& place) const { return *this == place; }
  auto operator<=>(const CaseSize&) const = default;
};

/// The clock of a time. Times of two clocks share neither a column nor a ratio.
enum class Clock {
  cpu,   ///< CPU time of one thread
  wall,  ///< time that passes: for several threads, and for analyses compared with these
};

/// Times of the timing windows into which a motion is cut: pieces between two clock readings, whose
/// numbers of instants differ by one at most. A time that is not cut may count as one window.
/// Vectors have one element for each window, or are empty where the record has none.
struct Windows {
  std::vector<double> least = {};  ///< least time [s] that any analysis took
  // The following are empty where updates are not counted.
  std::vector<double> instants = {};              ///< number of instants
  std::vector<double> updates = {};               ///< number of unknowns that Newton's method moved
  std::vector<std::vector<double>> samples = {};  ///< times [s] of all windows, by analysis
};

/// Samples of a time, by one clock.
struct Time {
  Clock clock = Clock::cpu;
  std::vector<double> seconds;  ///< samples [s], one for each repetition
  /// One for a step. For a motion: none unless the record's settings have windows; one by the wall
  /// clock.
  Windows windows;
};

/// Tells whether a formulation with this id is measured by the wall clock.
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

/// The origin of a time. Digests are SHA-256. A member is none where it is not recorded.
struct Origin {
  std::optional<std::string> machine;  ///< name of the CPU
  std::optional<std::string> model;    ///< digest of the modelled mechanism
  std::optional<std::string> results;  ///< digest of the answers, rounded to what is allowed
};

/// The measurement of an analysis, or of a step of one, which may have failed.
struct Measurement {
  Status status = Status::not_run;
  std::string message;  ///< why it has no time; may be empty
  Origin origin = {};
  Time time = {};  ///< has samples when ok only
  /// Largest differences from the reference: absolute; of a scene of the user's own relative.
  std::optional<LevelNumbers> verification = {};
  std::optional<double> setup_seconds = {};  ///< CPU time of the set-up [s], not part of `time`
  std::optional<double> iterations_per_step = {};
};

}  // namespace desmo::report
