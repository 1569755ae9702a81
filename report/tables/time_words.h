// What the times of a record are, in words.
#pragma once

#include <string>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Tells whether times are taken from samples of timing windows.
bool has_samples_of_windows(const Record& record);

/// The words for the times of a record in its notes: undisturbed times where it has timing
/// windows, medians where it has none.
struct TimeWords {
  std::string time;        ///< "median"
  std::string times;       ///< "medians"
  std::string beside;      ///< " (and median)", where that is another time
  std::string definition;  ///< a note; empty where the words need none
};

TimeWords time_words(const Record& record);

/// For the beginning of a sentence.
std::string capitalised(std::string text);

/// Adds the definition to the notes of a table that uses the words.
void define_time(Table& table, const Record& record);

/// "5 repetitions", "3 to 5 repetitions", "1 repetition": of all candidates that were measured.
std::string repetitions(const Record& record);

}  // namespace desmo::report
