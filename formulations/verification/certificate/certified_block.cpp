#include "formulations/verification/certificate/certified_block.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace desmo {

CertifiedBlock::CertifiedBlock(IntervalBlock equations, std::vector<int> rows, int columns,
                               std::vector<double> magnitudes)
    : equations_(std::move(equations)),
      rows_(std::move(rows)),
      magnitudes_(std::move(magnitudes)),
      rounding_((16 * width() + 4 * columns + 64) * Interval::unit) {
  const std::size_t n = magnitudes_.size();
  for (const Level level : levels) {
    jacobian_[level] = equations_.make_matrix();
    slopes_[level].resize(n * rows_.size());
    phi_[level].resize(n);
  }
  for (std::vector<double>* matrix : {&inverse_, &remainder_}) matrix->resize(n * n);
  for (std::vector<double>* vector : {&weights_, &trial_, &contracted_}) vector->resize(n);
}

void CertifiedBlock::evaluate(const IntervalState& delivered, Level level) {
  if (level == Level::position)
    equations_.residual(delivered.position.data(), phi_.position.data());
  else
    equations_.motion(
        {delivered.position.data(), delivered.velocity.data(), delivered.acceleration.data()},
        level, {phi_.position.data(), phi_.velocity.data(), phi_.acceleration.data()});
  if (inverted_ && equations_.is_linear()) return;
  equations_.jacobian(delivered.position.data(), jacobian_.position);
  inverted_ = invert();
  if (!inverted_) return;
  find_remainder();
  find_slopes(jacobian_.position, slopes_.position, size());
}

bool CertifiedBlock::prove_positions(IntervalState& state, PerLevel<ErrorRows>& all) {
  if (!inverted_) return false;
  ErrorRows& errors = all.position;
  std::ranges::fill(trial_, 0);
  constexpr int attempts = 6;
  for (int attempt = 0; attempt <= attempts; ++attempt) {
    // The first time the trial box is a point. Then X is larger than what the last test returned
    // (epsilon inflation; Rump). A part of the magnitude serves errors that are exactly zero.
    start(Level::position, errors);
    add_image(jacobian_.position, slopes_.position, 1, size(), errors, errors);
    add_uncertainty(errors);
    contract();
    bool inside = attempt > 0;
    for (int i = 0; i < size(); ++i) {
      const double image = (errors.sum[rows_[i]] + contracted_[i]) * (1 + rounding_);
      inside = inside && image < trial_[i];
      weights_[i] = image;
    }
    if (inside) {
      for (int i = 0; i < size(); ++i) add_own(errors, i, contracted_[i]);
      return finish(Level::position, state, errors);
    }
    for (int i = 0; i < size(); ++i) {
      trial_[i] = 1.1 * weights_[i] + 0x1p-60 * magnitudes_[i];
      state.position[equations_.unknowns()[i]].radius = trial_[i];
    }
    if (!equations_.is_linear())  // radii; midpoints stay the same
      equations_.jacobian(state.position.data(), jacobian_.position);
  }
  return false;
}

bool CertifiedBlock::bound_rates(Level level, const IntervalState& delivered, IntervalState& state,
                                 PerLevel<ErrorRows>& all) {
  ErrorRows& errors = all[level];
  start(level, errors);
  add_image(jacobian_.position, slopes_.position, 1, size(), errors, errors);
  if (!equations_.is_linear()) {
    // Φ̇_q and Φ̈_q within the errors of all lower levels, at the delivered rates of this one. Those
    // at lower levels keep their midpoints.
    const bool of_velocity = level == Level::velocity;
    equations_.jacobian_rates(
        {state.position.data(), (of_velocity ? delivered : state).velocity.data(),
         delivered.acceleration.data()},
        level, jacobian_);
    find_slopes(jacobian_[level], slopes_[level], 0);
    add_image(jacobian_[level], slopes_[level], 1, 0, all.position, errors);
    if (!of_velocity) add_image(jacobian_.velocity, slopes_.velocity, 2, 0, all.velocity, errors);
  }
  add_uncertainty(errors);
  // With A = |I − Y Φ_φ(X)| and A r ≤ η r, errors e ≤ b + A e are at most b + A r max(b/r)/(1 − η).
  double ratio = 0, contraction = 0;
  for (int i = 0; i < size(); ++i) {
    ratio = std::max(ratio, errors.sum[rows_[i]] / trial_[i]);
    contraction = std::max(contraction, contracted_[i] / trial_[i]);
  }
  const double factor = ratio / (1 - contraction) * (1 + rounding_);
  for (int i = 0; i < size(); ++i) add_own(errors, i, contracted_[i] * factor);
  return finish(level, state, errors);
}

/// Gauss–Jordan elimination with pivots that are large in their rows. An inaccurate inverse only
/// makes the test fail.
bool CertifiedBlock::invert() {
  const int n = size();
  for (int i = 0; i < n; ++i) {
    double largest = 0;
    for (int j = 0; j < n; ++j) {
      remainder_[i * n + j] = jacobian_.position.mid[i * width() + j];
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

void CertifiedBlock::find_remainder() {
  const int n = size();
  for (int i = 0; i < n; ++i) {
    double* remainder = &remainder_[i * n];
    for (int j = 0; j < n; ++j) remainder[j] = i == j;
    for (int r = 0; r < n; ++r) {
      const double y = inverse_[i * n + r];
      const double* row = &jacobian_.position.mid[r * width()];
      for (int j = 0; j < n; ++j) remainder[j] -= y * row[j];
    }
    for (int j = 0; j < n; ++j) remainder[j] = std::abs(remainder[j]);
    remainder[i] += rounding_;  // what is left of 1 was rounded
  }
}

/// Writes −Y times the derivatives, from column `first` on.
void CertifiedBlock::find_slopes(const IntervalMatrix& derivative, std::vector<double>& slopes,
                                 int first) const {
  const int n = size(), w = width();
  std::ranges::fill(slopes, 0);
  for (int i = 0; i < n; ++i)
    for (int r = 0; r < n; ++r) {
      const double y = inverse_[i * n + r];
      if (y == 0) continue;
      for (int j = first; j < w; ++j) slopes[i * w + j] -= y * derivative.mid[r * w + j];
    }
}

/// Starts the rows of the unknowns with −Y Φ.
void CertifiedBlock::start(Level level, ErrorRows& to) {
  const int n = size();
  const std::vector<Interval>& phi = phi_[level];
  for (int i = 0; i < n; ++i) {
    const int row = rows_[i];
    double center = 0;
    for (int r = 0; r < n; ++r) center -= inverse_[i * n + r] * phi[r].mid;
    to.center[row] = center;
    to.own[row] = 0;
    std::fill_n(to.of_row(row), to.columns, 0);
  }
  for (int r = 0; r < n; ++r) weights_[r] = phi[r].radius + rounding_ * std::abs(phi[r].mid);
}

/// Adds −Y (factor × derivative) times the errors of the coordinates from column `first` on.
/// Collects the uncertainty of the derivative times these errors, and all rounding.
void CertifiedBlock::add_image(const IntervalMatrix& derivative, const std::vector<double>& slopes,
                               double factor, int first, const ErrorRows& from, ErrorRows& to) {
  const int n = size(), w = width(), columns = to.columns;
  for (int i = 0; i < n; ++i) {
    const int row = rows_[i];
    double* generators = to.of_row(row);
    for (int j = first; j < w; ++j) {
      const double t = factor * slopes[i * w + j];
      if (t == 0) continue;
      const double* image = from.of_row(rows_[j]);
      for (int k = 0; k < columns; ++k) generators[k] += t * image[k];
      to.center[row] += t * from.center[rows_[j]];
      to.own[row] += std::abs(t) * from.own[rows_[j]];
    }
  }
  for (int r = 0; r < n; ++r)
    for (int j = first; j < w; ++j)
      weights_[r] +=
          factor * (derivative.radius[r * w + j] * from.radius[rows_[j]] +
                    rounding_ * std::abs(derivative.mid[r * w + j]) * from.sum[rows_[j]]);
}

/// Adds |Y| times the uncertainty of the equations to the rows of the unknowns.
void CertifiedBlock::add_uncertainty(ErrorRows& to) {
  const int n = size();
  for (int i = 0; i < n; ++i) {
    const int row = rows_[i];
    double own = to.own[row] * (1 + rounding_) + Interval::tiny;
    for (int r = 0; r < n; ++r) own += std::abs(inverse_[i * n + r]) * weights_[r];
    to.own[row] = own * (1 + rounding_);
    double sum = std::abs(to.center[row]) + to.own[row];
    for (int k = 0; k < to.columns; ++k) sum += std::abs(to.of_row(row)[k]);
    to.sum[row] = sum * (1 + rounding_);
  }
}

/// Bounds |(I − Y Φ_φ(X)) X| by the radii of X.
void CertifiedBlock::contract() {
  const int n = size(), w = width();
  const IntervalMatrix& jacobian = jacobian_.position;
  for (int r = 0; r < n; ++r) {
    weights_[r] = 0;
    for (int j = 0; j < n; ++j)
      weights_[r] +=
          (jacobian.radius[r * w + j] + rounding_ * std::abs(jacobian.mid[r * w + j])) * trial_[j];
  }
  for (int i = 0; i < n; ++i) {
    double sum = Interval::tiny;
    for (int r = 0; r < n; ++r)
      sum += remainder_[i * n + r] * trial_[r] + std::abs(inverse_[i * n + r]) * weights_[r];
    contracted_[i] = sum * (1 + rounding_);
  }
}

void CertifiedBlock::add_own(ErrorRows& to, int i, double radius) const {
  double& own = to.own[rows_[i]];
  own = (own + radius) * (1 + rounding_);
}

/// Completes the rows of the unknowns. Returns false unless all are finite.
bool CertifiedBlock::finish(Level level, IntervalState& state, ErrorRows& errors) {
  for (int i = 0; i < size(); ++i) {
    const int row = rows_[i];
    double sum = std::abs(errors.center[row]) + errors.own[row];
    for (int k = 0; k < errors.columns; ++k) sum += std::abs(errors.of_row(row)[k]);
    sum *= 1 + rounding_;
    if (!std::isfinite(sum)) return false;
    errors.sum[row] = errors.radius[row] = sum;
    state[level][equations_.unknowns()[i]].radius = sum;
  }
  return true;
}

}  // namespace desmo
