// What a check's times and counts of instructions mean, candidate by candidate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/check/check_record.h"
#include "report/check/median_change.h"
#include "report/statistics/comparability.h"

namespace desmo::report {

/// Limits of the ratio time of head / time of base. An alarm needs two passes, in each of which the
/// median of the ratio is above max_change, and the lower end of the median's interval is above
/// max_certain_change. An improvement is what would be an alarm with base and head exchanged.
inline constexpr double max_change = 1.05;
inline constexpr double max_certain_change = 1.02;
/// Largest width of an interval, upper end / lower end, ≤. A wider interval does not show that
/// nothing has changed.
inline constexpr double max_interval_width = 1.05;
/// Largest ratio of the control's times, in either direction, ≤. A larger one, or an interval wider
/// than max_interval_width, makes all times too noisy.
inline constexpr double max_control_change = 1.02;
/// Least increase of the number of instructions that raises an alarm [%], ≥. It is compared with
/// the increase that is shown, which is rounded to a tenth.
inline constexpr double min_alarming_percent = 1.0;

/// The finding on one candidate, by time or by work.
enum class Finding {
  same,
  improvement,
  regression,
  unconfirmed,  ///< the first pass shows a change, and there is no second pass
  refuted,      ///< the second pass does not show the change that the first did
  noisy,        ///< more rounds are needed
};

/// Returns whether the control's times changed so much, or have so wide an interval, that no time
/// can be judged: the machine has changed.
bool is_unsteady(const Change& control);

struct TimeFinding {
  std::string candidate;
  double base_seconds = 0, head_seconds = 0;  ///< medians of the first pass's rounds [s]
  Change first;                               ///< change by the first pass
  std::optional<Change> second = {};          ///< change by the second pass; none: it is missing
  Finding outcome = Finding::same;
};

struct TimeFindings {
  std::optional<Change> control;  ///< change of the control in the first pass; none: nothing timed
  std::vector<TimeFinding> candidates;
};

/// Compares the times of head with those of base, round by round.
TimeFindings find_times(const CheckRecord& check);

struct WorkFinding {
  std::string candidate;
  std::int64_t base = 0, head = 0;  ///< numbers of instructions
  double percent = 0;               ///< change from base to head [%], rounded to a tenth
  Finding outcome = Finding::same;
};

struct WorkFindings {
  /// Why the counts cannot be compared; `candidates` is then empty.
  std::vector<Difference> differences;
  std::vector<WorkFinding> candidates;  ///< candidates that were counted on both sides
};

/// Compares the counts of head with those of base; where a baseline is given (not null), with those
/// of the baseline's head. Counts depend on compiler, flags, libraries and tool, but not on the
/// processor: callgrind, which counts, shows every program the same one.
WorkFindings find_works(const CheckRecord& check, const CheckRecord* baseline);

}  // namespace desmo::report
