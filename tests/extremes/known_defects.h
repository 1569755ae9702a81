#pragma once

#include <span>
#include <string>
#include <string_view>

#include "bench/experiments/extremes/table.h"

namespace desmo::extreme {

/// An extreme case that some formulation of the short run does not solve as expected.
struct KnownDefect {
  int row;  ///< row of the table of extremes
  std::string case_name;
  Verdict verdict;  ///< worst verdict of all formulations
};

/// Returns all known defects. The list may only become shorter: a listed case with another verdict
/// fails its test.
std::span<const KnownDefect> known_defects();

/// Returns the known defect of a case, or null.
const KnownDefect* find_known_defect(int row, std::string_view case_name);

}  // namespace desmo::extreme
