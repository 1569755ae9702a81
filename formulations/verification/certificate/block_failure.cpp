#include <cmath>

#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/block_proof.h"

namespace desmo {

/// Judges by positions, even if these are proven and rates are not. Takes the unknown with the
/// largest ratio of error bound to trial radius. The errors of the inputs are the cause if they
/// make up more than half of that bound. Otherwise the sizes of the terms decide.
ProofFailure BlockProof::failure(int lane) const {
  if (condition_[lane] == 0) return ProofFailure::time;  // radii are infinite: no X was tried
  const ErrorColumns& e = errors_.position;
  const int n = shape_->unknowns;
  int worst = 0;
  double largest = 0;
  for (int i = 0; i < n; ++i) {
    const double ratio = (2 * contracted_[i][lane] + e.sum[i][lane]) / trial_[i][lane];
    if (!std::isfinite(ratio)) return ProofFailure::singular;
    if (ratio > largest) largest = ratio, worst = i;
  }
  double drivers = 0, time = 0, rounded = 0;
  for (int r = 0; r < n; ++r)
    for (int k = shape_->input_begins[r]; k < shape_->row_begins[r + 1]; ++k) {
      const int j = shape_->entries[k];
      const double slope =
          std::abs(y_->inverse[worst * n + r][lane]) *
          (std::abs(batch_->jacobian.mid[k][lane]) + batch_->jacobian.radius[k][lane]);
      drivers += slope * std::abs(e.centre[j][lane]);
      time += slope * e.own[j][lane];
    }
  // Errors above u × magnitude are themselves the cause. Below that X is hardly larger than
  // u × magnitude: the test then fails because |I − Y Φ_φ| X is too large.
  const double size = batch_->magnitudes[worst][lane], error = e.sum[worst][lane];
  const double at = std::abs(state_.position[batch_->locals[worst]].mid[lane]);
  if (error > size * Interval::unit) {
    if (std::max(drivers, time) > error / 2)
      return drivers > time ? ProofFailure::drivers : ProofFailure::time;
    if (error > at * Interval::unit) return ProofFailure::far_off;
    return ProofFailure::origin;
  }
  for (int r = 0; r < n; ++r)
    for (int k = shape_->row_begins[r]; k < shape_->input_begins[r]; ++k)
      rounded += std::abs(y_->inverse[worst * n + r][lane] * batch_->jacobian.mid[k][lane]) *
                 trial_[shape_->entries[k]][lane] * batch_->rounding;
  return rounded > contracted_[worst][lane] / 2 ? ProofFailure::sizes : ProofFailure::singular;
}

}  // namespace desmo
