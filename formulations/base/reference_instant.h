#pragma once

#include <vector>

namespace desmo {

/// A solved instant in coordinate order, fixed entities left out.
struct ReferenceInstant {
  double time;                     ///< [s]
  std::vector<double> q, qd, qdd;  ///< rounded to double

  /// Remainders of the rounding, themselves rounded: value = q + remainder.q to 1e-32 of it. Empty:
  /// not known.
  struct Remainders {
    std::vector<double> q, qd, qdd;
  };
  Remainders remainder = {};
};

}  // namespace desmo
