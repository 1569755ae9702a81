#pragma once

#include <functional>
#include <regex>
#include <string>
#include <vector>

#include "bench/stability/judgement.h"
#include "cases/extremes.h"

namespace desmo::extreme {

/// One place of the table.
struct Result {
  const Extreme* row;
  std::string case_name;
  std::string id;        ///< formulation, with the case's settings
  double condition = 0;  ///< the largest of what was compared; 0: not known
  Judgement judgement;
};

/// Every case of a row in every formulation whose id the expression is found in. done: called after
/// each case, with its name.
std::vector<Result> row_results(const Extreme& row, Extent extent, const std::regex& formulations,
                                const std::function<void(const std::string&)>& done = {});

}  // namespace desmo::extreme
