#pragma once

#include <span>
#include <string>
#include <string_view>

#include "bench/experiments/extremes/table.h"

namespace desmo::extremes {

/// A case that is not as expected in some formulation of the short form.
struct KnownDefect {
  int row;
  std::string case_name;
  Verdict verdict;  ///< the worst
};

/// All there are. The list may only become shorter: a case on it that does better, or worse, fails
/// its test.
std::span<const KnownDefect> known_defects();

/// Null when the case is as expected.
const KnownDefect* find_known_defect(int row, std::string_view case_name);

}  // namespace desmo::extremes
