// How a time grows with a size, as a place of a table.
#pragma once

#include <string>
#include <vector>

#include "report/statistics/statistics.h"
#include "report/text/document.h"

namespace desmo::report {

/// Times at sizes, one each.
struct SizedTimes {
  std::vector<double> sizes;
  std::vector<double> seconds;
  std::string mark;  ///< of a size that has no number; empty where there is none
};

/// Returns what the words of slope_entry mean, for the notes of a table.
std::string linear_note();
bool is_linear(double slope);

/// What a slope_entry's numbers are.
inline const std::vector<std::string> slope_quantities{"slope", "low", "high", "sizes"};

/// "1.012 [0.990, 1.034] n=5 linear", the log-log slope; the number of sizes where there are too
/// few for one, or the mark.
Entry slope_entry(const SizedTimes& times);

}  // namespace desmo::report
