// The rules of the check.
#pragma once

#include <optional>

#include "report/check/median_change.h"

namespace desmo::report {

/// Time: an alarm when the median change exceeds the first and the lower end of its interval the
/// second, in two passes in a row. An improvement is the same with base and head exchanged.
inline constexpr double alarming_change = 1.05;
inline constexpr double certain_change = 1.02;
/// Wider intervals than this, highest over lowest, tell nothing.
inline constexpr double max_interval = 1.05;
/// The control's time may not change by more, nor its interval be wider than the above.
inline constexpr double steady_control = 1.02;
/// Work: an alarm from this change on, in percent rounded to the tenth that is shown.
inline constexpr double alarming_percent = 1.0;

enum class Outcome {
  same,
  improvement,
  regression,
  unconfirmed,  ///< needs its second pass
  refuted,      ///< the second pass does not say what the first did
  noisy,        ///< needs more rounds
};

/// Returns the finding of a time, from its changes in the first pass and, where there was one, the
/// second.
Outcome outcome_of_time(const Change& first, const std::optional<Change>& second);

/// Returns whether the machine, and not what was measured, changed so much that no time can be
/// judged.
bool is_unsteady(const Change& control);

/// Returns the finding of a change of instructions in percent, rounded to a tenth.
Outcome outcome_of_work(double percent);

}  // namespace desmo::report
