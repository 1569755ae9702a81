#include "formulations/verification/certificate/certified_block.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace desmo {

CertifiedBlock::CertifiedBlock(IntervalBlock equations, Places places,
                               std::vector<double> magnitudes)
    : equations_(std::move(equations)),
      places_(std::move(places)),
      magnitudes_(std::move(magnitudes)),
      rounding_((4 * (size() + inputs()) + 2 * places_.columns + 32) * Interval::unit),
      jacobian_(equations_.make_matrix()) {
  const std::size_t n = magnitudes_.size();
  for (std::vector<double>* matrix : {&inverse_, &remainder_}) matrix->resize(n * n);
  transfer_.resize(n * places_.input_rows.size());
  phi_.resize(n);
  for (std::vector<double>* vector : {&weights_, &own_, &trial_, &contracted_}) vector->resize(n);
}

bool CertifiedBlock::prove_positions(const IntervalState& delivered, IntervalState& state,
                                     ErrorRows& errors) {
  equations_.residual(delivered.position.data(), phi_.data());
  if (!sloped_) {
    equations_.jacobian(delivered.position.data(), jacobian_);
    if (!invert()) return false;
    find_slopes();
    sloped_ = equations_.is_linear();
  }
  propagate(errors);
  find_uncertainty(errors);
  std::ranges::fill(contracted_, 0);
  constexpr int attempts = 6;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    // Epsilon inflation (Rump): X is larger than what the last test returned. A part of the
    // magnitude serves errors that are exactly zero.
    for (int i = 0; i < size(); ++i) {
      const double last = errors.sum[places_.unknown_rows[i]] + own_[i] + contracted_[i];
      trial_[i] = 1.1 * last + 0x1p-60 * magnitudes_[i];
      state.position[equations_.unknowns()[i]].radius = trial_[i];
    }
    if (!equations_.is_linear()) {
      equations_.jacobian(state.position.data(), jacobian_);  // radii; midpoints stay the same
      find_uncertainty(errors);
    }
    contract();
    if (!is_inside(errors)) continue;
    for (int i = 0; i < size(); ++i) own_[i] += contracted_[i];
    return finish(errors, state.position);
  }
  return false;
}

bool CertifiedBlock::bound_rates(Level level, const IntervalState& delivered, IntervalState& state,
                                 ErrorRows& errors) {
  if (level == Level::velocity)
    equations_.velocity(state.position.data(), delivered.velocity.data(), phi_.data());
  else
    equations_.acceleration(state.position.data(), state.velocity.data(),
                            delivered.acceleration.data(), phi_.data());
  propagate(errors);
  find_uncertainty(errors);
  // With A = |I − Y Φ_φ(X)| and A r ≤ η r, errors e ≤ b + A e are at most b + A r max(b/r)/(1 − η).
  double ratio = 0, contraction = 0;
  for (int i = 0; i < size(); ++i) {
    ratio = std::max(ratio, (errors.sum[places_.unknown_rows[i]] + own_[i]) / trial_[i]);
    contraction = std::max(contraction, contracted_[i] / trial_[i]);
  }
  const double factor = ratio / (1 - contraction) * (1 + rounding_);
  for (int i = 0; i < size(); ++i) own_[i] += contracted_[i] * factor;
  return finish(errors, state[level]);
}

/// Gauss–Jordan elimination with pivots that are large in their rows. An inaccurate inverse only
/// makes the test fail.
bool CertifiedBlock::invert() {
  const int n = size(), width = n + inputs();
  for (int i = 0; i < n; ++i) {
    double largest = 0;
    for (int j = 0; j < n; ++j) {
      remainder_[i * n + j] = jacobian_.mid[i * width + j];
      inverse_[i * n + j] = i == j;
      largest = std::max(largest, std::abs(remainder_[i * n + j]));
    }
    weights_[i] = largest > 0 ? 1 / largest : 1;
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(remainder_[i * n + k]) * weights_[i] >
          std::abs(remainder_[pivot * n + k]) * weights_[pivot])
        pivot = i;
    if (!(std::abs(remainder_[pivot * n + k]) > 0)) return false;
    if (pivot != k) {
      std::swap(weights_[k], weights_[pivot]);
      for (std::vector<double>* matrix : {&remainder_, &inverse_})
        std::swap_ranges(matrix->begin() + k * n, matrix->begin() + (k + 1) * n,
                         matrix->begin() + pivot * n);
    }
    const double scale = 1 / remainder_[k * n + k];
    for (int j = 0; j < n; ++j) remainder_[k * n + j] *= scale, inverse_[k * n + j] *= scale;
    for (int i = 0; i < n; ++i) {
      const double factor = remainder_[i * n + k];
      if (i == k || factor == 0) continue;
      for (int j = 0; j < n; ++j) {
        remainder_[i * n + j] -= factor * remainder_[k * n + j];
        inverse_[i * n + j] -= factor * inverse_[k * n + j];
      }
    }
  }
  return true;
}

void CertifiedBlock::find_slopes() {
  const int n = size(), m = inputs(), width = n + m;
  std::ranges::fill(transfer_, 0);
  for (int i = 0; i < n; ++i) {
    double* remainder = &remainder_[i * n];
    for (int j = 0; j < n; ++j) remainder[j] = i == j;
    for (int r = 0; r < n; ++r) {
      const double y = inverse_[i * n + r];
      if (y == 0) continue;
      const double* row = &jacobian_.mid[r * width];
      for (int j = 0; j < n; ++j) remainder[j] -= y * row[j];
      for (int p = 0; p < m; ++p) transfer_[i * m + p] -= y * row[n + p];
    }
    for (int j = 0; j < n; ++j) remainder[j] = std::abs(remainder[j]);
    remainder[i] += rounding_;  // what is left of 1 was rounded
  }
}

/// Writes center, generators and sum of the unknowns: −Y Φ − Y Φ_h δ.
void CertifiedBlock::propagate(ErrorRows& errors) const {
  const int n = size(), m = inputs(), columns = errors.columns, before = places_.first_symbol;
  for (int i = 0; i < n; ++i) {
    const int row = places_.unknown_rows[i];
    double center = 0;
    double* generators = errors.of_row(row);
    std::fill_n(generators, columns, 0);
    for (int r = 0; r < n; ++r) center -= inverse_[i * n + r] * phi_[r].mid;
    for (int p = 0; p < m; ++p) {
      const double t = transfer_[i * m + p];
      if (t == 0) continue;
      const int input = places_.input_rows[p];
      center += t * errors.center[input];
      const double* of_input = errors.of_row(input);
      for (int k = 0; k < before; ++k) generators[k] += t * of_input[k];
    }
    double sum = std::abs(center);
    for (int k = 0; k < before; ++k) sum += std::abs(generators[k]);
    errors.center[row] = center;
    errors.sum[row] = sum * (1 + rounding_);
  }
}

/// Finds what remains of each unknown's error: |Y| times the radius of Φ, of Φ_h times the errors
/// of the inputs, and the rounding of propagate().
void CertifiedBlock::find_uncertainty(const ErrorRows& errors) {
  const int n = size(), m = inputs(), width = n + m;
  for (int r = 0; r < n; ++r) {
    double weight = phi_[r].radius + rounding_ * std::abs(phi_[r].mid);
    const double* mid = &jacobian_.mid[r * width + n];
    const double* radius = &jacobian_.radius[r * width + n];
    for (int p = 0; p < m; ++p) {
      const int input = places_.input_rows[p];
      weight += radius[p] * errors.radius[input] + rounding_ * std::abs(mid[p]) * errors.sum[input];
    }
    weights_[r] = weight;
  }
  for (int i = 0; i < n; ++i) {
    double sum = 0;
    for (int r = 0; r < n; ++r) sum += std::abs(inverse_[i * n + r]) * weights_[r];
    own_[i] = sum * (1 + rounding_) + Interval::tiny;
  }
}

/// Bounds |(I − Y Φ_φ(X)) X| by the radii of X.
void CertifiedBlock::contract() {
  const int n = size(), width = n + inputs();
  for (int r = 0; r < n; ++r) {
    double weight = 0;
    for (int j = 0; j < n; ++j)
      weight +=
          (jacobian_.radius[r * width + j] + rounding_ * std::abs(jacobian_.mid[r * width + j])) *
          trial_[j];
    weights_[r] = weight;
  }
  for (int i = 0; i < n; ++i) {
    double sum = 0;
    for (int r = 0; r < n; ++r)
      sum += remainder_[i * n + r] * trial_[r] + std::abs(inverse_[i * n + r]) * weights_[r];
    contracted_[i] = sum * (1 + rounding_) + Interval::tiny;
  }
}

bool CertifiedBlock::is_inside(const ErrorRows& errors) const {
  for (int i = 0; i < size(); ++i) {
    const double image = errors.sum[places_.unknown_rows[i]] + own_[i] + contracted_[i];
    if (!(image * (1 + rounding_) < trial_[i])) return false;
  }
  return true;
}

/// Completes the rows of the unknowns with their own errors. Returns false unless all are finite.
bool CertifiedBlock::finish(ErrorRows& errors, std::vector<Interval>& state) const {
  for (int i = 0; i < size(); ++i) {
    const int row = places_.unknown_rows[i];
    const double own = own_[i] * (1 + rounding_);
    if (places_.symbols[i] >= 0) errors.of_row(row)[places_.symbols[i]] = own;
    const double sum = (errors.sum[row] + own) * (1 + rounding_);
    if (!std::isfinite(sum)) return false;
    errors.sum[row] = errors.radius[row] = state[equations_.unknowns()[i]].radius = sum;
  }
  return true;
}

}  // namespace desmo
