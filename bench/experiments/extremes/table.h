#pragma once

#include <functional>
#include <regex>
#include <string>
#include <vector>

#include "bench/experiments/extremes/verification.h"
#include "cases/extremes/extremes.h"

namespace desmo::extremes {

/// The verdict on one formulation in one case; a row of the table has many cases.
struct Result {
  const Extreme* row;
  std::string case_name;
  std::string id;  ///< formulation, with the case's settings
  Verification verification;
};

/// The part of the table that is tried.
struct Selection {
  Extent extent = Extent::full;
  /// Expressions that are found in ids, and in the names of cases; by default in all.
  std::regex formulations{""}, cases{""};
  /// Function that is called after each case with its share of the row; may be empty.
  std::function<void(double)> on_case_done = {};
};

/// Returns the results of a row in the formulations selected. A case with which others are compared
/// is tried with them, selected or not.
std::vector<Result> row_results(const Extreme& row, const Selection& selection);

}  // namespace desmo::extremes
