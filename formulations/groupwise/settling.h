#pragma once

#include <cmath>
#include <limits>

namespace desmo {

/// Tells from the sizes of Newton's corrections, relative to natural magnitudes, when only the
/// rounding of S is left: they no longer count, or are small and no longer shrink because
/// conditioning allows no better. It does not depend on units, as a bound on ‖Φ‖ would.
template <class S>
class Settling {
 public:
  /// One more correction was made, of this relative size. True: it was the last that helps.
  bool operator()(double correction) {
    const bool stagnates = correction < std::sqrt(epsilon) && correction > before_ / 2;
    before_ = correction;
    return correction < 1000 * epsilon || stagnates;
  }

 private:
  static inline const double epsilon = static_cast<double>(std::numeric_limits<S>::epsilon());
  double before_ = INFINITY;
};

}  // namespace desmo
