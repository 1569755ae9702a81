// Words for the times, the repetitions and the motion of a record.
#pragma once

#include <string>

#include "report/read/record.h"
#include "report/text/texts.h"

namespace desmo::report {

/// Returns the values of placeholders in texts about the times of the paper's experiment, followed
/// by `more`:
/// - time: "undisturbed time" where the record has timing windows, "median" where it has none
/// - time_and_median: the same, with "(and median)" where undisturbed times have intervals
/// - definition: what an undisturbed time is; empty without timing windows
/// - cpu, date, duration: name of the CPU, date of the record, duration of the motion [s]
/// - repetitions: "5 repetitions", "3 to 5 repetitions", of all candidates by the CPU clock
/// - the words of the block "intervals"; empty where all that was measured has fewer than three
///   repetitions
/// - one_digit: how times without an interval are shown; empty unless some have one and some do not
TextValues timed_words(const Record& record, const TextValues& more = {});

/// Words that tell our values from the paper's: "ours" and "paper" when both motions last equally
/// long, else "ours, 2 s" and "paper, 30 s".
struct Sources {
  std::string ours;
  std::string paper;
  std::string warning;        ///< why the times cannot be compared; empty when they can
  std::string ratio_warning;  ///< why the ratios may differ; empty when `warning` is
};

Sources sources(const Record& record);

}  // namespace desmo::report
