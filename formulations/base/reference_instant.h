#pragma once

#include <vector>

namespace desmo {

/// A solved instant in coordinate order, fixed entities left out.
struct ReferenceInstant {
  double time;                     ///< [s]
  std::vector<double> q, qd, qdd;  ///< rounded to double; units as in Instant

  /// Remainders of the rounding, themselves rounded: exact value = q + remainder.q, to a relative
  /// error of about 1e-32. Empty: unknown.
  struct Remainders {
    std::vector<double> q, qd, qdd;
  };
  Remainders remainder = {};
};

}  // namespace desmo
