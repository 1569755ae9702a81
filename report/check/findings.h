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

/// Changes of time that raise an alarm: the median exceeds the first, and the lower end of its
/// interval the second, in two passes in a row. An improvement is the same with base and head
/// exchanged.
inline constexpr double alarming_change = 1.05;
inline constexpr double certain_change = 1.02;
/// Wider intervals than this, highest over lowest, do not show that nothing has changed.
inline constexpr double max_interval = 1.05;
/// The control's time may not change by more, nor its interval be wider than the above.
inline constexpr double steady_control = 1.02;
/// Change of the instructions that raises an alarm, in percent rounded to the tenth that is shown.
inline constexpr double alarming_percent = 1.0;

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
