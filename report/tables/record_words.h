// A record in words: its commit, its times, its repetitions and its motion.
#pragma once

#include <string>

#include "report/read/record.h"
#include "report/text/texts.h"

namespace desmo::report {

/// Returns the commit, and whether there were changes that it does not have.
std::string commit_of(const Record& record);

/// Returns what texts about the times of the paper's experiment say, followed by `more`:
/// - time: "undisturbed time" where the record has timing windows, "median" where it has none
/// - time_and_median: the same, "(and median)" where that is another time
/// - definition: what an undisturbed time is; may be empty
/// - cpu, date, duration [s]: of what was measured on, when, and of the motion
/// - repetitions: "5 repetitions", "3 to 5 repetitions", of all candidates that were measured
/// - the words of the block "intervals", which are empty in a first look
/// - one_digit: how times without an interval are shown, where there are some besides others
TextValues timed_words(const Record& record, const TextValues& more = {});

/// Words that tell our values from the paper's: "ours" and "paper" when both are times of the same
/// motion, "ours, 2 s" and "paper, 30 s" when they are not.
struct Sources {
  std::string ours;
  std::string paper;
  std::string warning;        ///< why the times cannot be compared; empty when they can
  std::string ratio_warning;  ///< warning at ratios of the two
};

Sources sources(const Record& record);

}  // namespace desmo::report
