// A record in words: its commit, its times, its repetitions and its motion.
#pragma once

#include <string>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Tells whether times are taken from samples of timing windows.
bool has_samples_of_windows(const Record& record);

/// Returns the commit, and whether there were changes that it does not have.
std::string commit_of(const Record& record);

/// Returns "undisturbed time" where the record has timing windows, "median" where it has none.
std::string time_word(const Record& record);

/// Returns the same, with the median where that is another time: "undisturbed time (and median)".
std::string time_and_median(const Record& record);

/// Adds what an undisturbed time is to the notes of a table.
void define_time(Table& table, const Record& record);

/// "5 repetitions", "3 to 5 repetitions": of all candidates that were measured.
std::string repetitions(const Record& record);

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
