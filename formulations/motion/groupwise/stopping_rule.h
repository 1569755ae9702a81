#pragma once

#include <cmath>
#include <limits>

namespace desmo {

/// Stopping rule of a Newton iteration: tells when only the rounding of S is left. It looks at the
/// sizes of the corrections, relative to nominal magnitudes. With the machine epsilon ε of S, the
/// last one is below 1000 ε, or it is below √ε and above half the one before. The latter means that
/// conditioning allows no better. Unlike a bound on ‖Φ‖ the rule does not depend on units.
template <class S>
class StoppingRule {
 public:
  /// Maximum number of corrections: iteration < max_corrections. From a drawing the first ones may
  /// grow; where there is no solution they never settle.
  static constexpr int max_corrections = 50;

  /// Takes the relative size of a correction just made. Returns whether it was the last useful one.
  bool operator()(double correction) {
    const bool stagnates = correction < std::sqrt(epsilon) && correction > last_correction_ / 2;
    last_correction_ = correction;
    return correction < 1000 * epsilon || stagnates;
  }

 private:
  static inline const double epsilon = static_cast<double>(std::numeric_limits<S>::epsilon());
  double last_correction_ = INFINITY;
};

}  // namespace desmo
