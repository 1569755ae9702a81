// Correction of an instant by Newton steps with factors at its own position.
#include <algorithm>
#include <cmath>

#include "formulations/verification/assessment/assessor.h"

namespace desmo {

/// values −= Φ_φ⁻¹ of that order of the equations; the largest correction in their magnitudes.
double Assessor::correct(Level level, std::vector<double>& values) {
  if (system_.size() == 0) return 0;
  equations_of(level);
  system_.solve(off_.data());
  for (int j = 0; j < system_.size(); ++j) {
    const int i = system_.unknowns()[j];
    if (motion_.is_solved(i, level)) values[i] -= system_.magnitude(i) * off_[j];
  }
  return off_.abs().maxCoeff<Eigen::PropagateNaN>();
}

Instant Assessor::corrected(const Instant& instant) {
  constexpr int max_corrections = 10;
  auto& [q, qd, qdd] = corrected_;
  Instant result = instant;
  const auto put = [](std::span<const double> from, std::vector<double>& to) {
    std::ranges::copy(from, to.begin());
    return from.empty() ? from : std::span<const double>(to);
  };
  result.q = put(instant.q, q);
  result.qd = put(instant.qd, qd);
  result.qdd = put(instant.qdd, qdd);
  double before = INFINITY;
  for (int i = 0; i < max_corrections; ++i) {
    std::ranges::copy(q, state_.begin());
    last_correction_ = INFINITY;
    if (!system_.factor(state_)) return instant;
    motion_.take(result);
    last_correction_ = correct(Level::position, q);
    if (!(last_correction_ < before / 2)) break;
    before = last_correction_;
  }
  for (int pass = 0; pass < 2; ++pass)  // the second refines what the first has solved
    for (const Level level : {Level::velocity, Level::acceleration})
      if (!(level == Level::velocity ? result.qd : result.qdd).empty()) {
        motion_.take(result);
        correct(level, corrected_[level]);
      }
  return result;
}

}  // namespace desmo
