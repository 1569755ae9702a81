// Where two curves of time over size cross.
#pragma once

#include <optional>

#include "report/statistics/curves.h"

namespace desmo::report {

/// Unknowns from which on the second of two formulations is the faster.
struct BreakEven {
  double unknowns = 0;       ///< interpolated in log t over log n between the neighbours
  double low = 0, high = 0;  ///< the neighbours; of the first and the last where there are several
};

/// What two curves say, over the sizes that both have.
struct CurveComparison {
  std::size_t sizes = 0;
  double smallest = 0, largest = 0;  ///< unknowns; where there are sizes
  bool second_faster_at_largest = false;
  /// Nothing where one is the faster at every size, or the first at the largest.
  std::optional<BreakEven> break_even;
};

CurveComparison compare(const Curve& first, const Curve& second);

/// At each size the faster of the two; where only one has it, that one.
Curve faster_of(const Curve& a, const Curve& b);

}  // namespace desmo::report
