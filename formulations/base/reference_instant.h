#pragma once

#include <vector>

namespace desmo {

/// A solved instant: values of all coordinates in their order, without fixed entities.
struct ReferenceInstant {
  double time;                     ///< [s]
  std::vector<double> q, qd, qdd;  ///< rounded to double; units as in Instant

  /// Remainders that rounding to double took off, themselves rounded: exact value = q +
  /// remainder.q, to a relative error of about 1e-32. Empty: unknown.
  struct Remainders {
    std::vector<double> q, qd, qdd;
  };
  Remainders remainder = {};
};

}  // namespace desmo
