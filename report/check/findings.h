// Meaning of a check's times and instruction counts, candidate by candidate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/check/check_record.h"
#include "report/check/median_change.h"
#include "report/statistics/comparability.h"

namespace desmo::report {

/// Ratios of times, head over base, that raise an alarm: the median is above max_change and the
/// lower end of its interval above max_certain_change, in two passes in a row. An improvement is
/// the same with base and head exchanged.
inline constexpr double max_change = 1.05;
inline constexpr double max_certain_change = 1.02;
/// Largest width of an interval, its upper end over its lower one. A wider interval does not show
/// that nothing has changed.
inline constexpr double max_interval_width = 1.05;
/// Largest ratio of the control's times. A larger one, or an interval wider than the above, makes
/// all times too noisy.
inline constexpr double max_control_change = 1.02;
/// Least change of the instructions that raises an alarm [%], rounded to the tenth that is shown.
inline constexpr double min_alarming_percent = 1.0;

enum class Finding {
  same,
  improvement,
  regression,
  unconfirmed,  ///< needs its second pass
  refuted,      ///< the second pass does not say what the first did
  noisy,        ///< needs more rounds
};

/// Returns whether the machine, and not what was measured, changed so much that no time can be
/// judged.
bool is_unsteady(const Change& control);

struct TimeFinding {
  std::string candidate;
  double base_seconds = 0, head_seconds = 0;  ///< medians over the rounds
  Change first;
  std::optional<Change> second = {};
  Finding outcome = Finding::same;
};

struct TimeFindings {
  std::optional<Change> control;  ///< of the first pass; none when nothing was timed
  std::vector<TimeFinding> candidates;
};

/// Compares base with head, round by round.
TimeFindings find_times(const CheckRecord& check);

struct WorkFinding {
  std::string candidate;
  std::int64_t base = 0, head = 0;  ///< instructions
  double percent = 0;               ///< change, rounded to a tenth
  Finding outcome = Finding::same;
};

struct WorkFindings {
  std::vector<Difference> differences;  ///< why the counts cannot be compared; then no candidates
  std::vector<WorkFinding> candidates;  ///< candidates that both sides have counted
};

/// Compares head with base, or with a stored baseline. Counts depend on compiler, flags, libraries
/// and tool, but not on the processor: callgrind shows every program the same one.
WorkFindings find_works(const CheckRecord& check, const CheckRecord* baseline = nullptr);

}  // namespace desmo::report
