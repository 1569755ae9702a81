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
      quads_(equations_.stride() / 4),
      rounding_((16 * stride() + 4 * columns + 64) * Interval::unit) {
  const std::size_t n = magnitudes_.size();
  for (const Level level : levels) {
    jacobian_[level] = equations_.make_matrix();
    slopes_[level].resize(n * static_cast<std::size_t>(stride()));
    phi_[level].resize(n);
    Errors& e = near_[level];
    for (std::vector<double>* values : {&e.center, &e.own, &e.sum, &e.radius})
      values->resize(static_cast<std::size_t>(stride()));
  }
  for (std::vector<double>* matrix : {&inverse_, &remainder_}) matrix->resize(n * n);
  for (std::vector<double>* vector : {&weights_, &trial_, &contracted_}) vector->resize(n);
}

template <class Function>
auto CertifiedBlock::with_size(Function&& function) {
  switch (size()) {
    case 1:
      return function.template operator()<1>();
    case 2:
      return function.template operator()<2>();
    case 3:
      return function.template operator()<3>();
    case 4:
      return function.template operator()<4>();
    default:
      return function.template operator()<0>();
  }
}

void CertifiedBlock::gather_inputs(Level level, const ErrorRows& from) {
  Errors& e = near_[level];
  for (std::vector<double>* values : {&e.center, &e.own, &e.sum, &e.radius})
    std::fill_n(values->begin(), size(), 0);
  for (std::size_t j = magnitudes_.size(); j < rows_.size(); ++j) {
    e.center[j] = from.center[rows_[j]];
    e.own[j] = from.own[rows_[j]];
    e.sum[j] = from.sum[rows_[j]];
    e.radius[j] = from.radius[rows_[j]];
  }
}

/// Gauss–Jordan elimination with pivots that are large in their rows. An inaccurate inverse only
/// makes the test fail.
template <int N>
bool CertifiedBlock::invert() {
  const int n = this->n<N>();
  for (int i = 0; i < n; ++i) {
    double largest = 0;
    for (int j = 0; j < n; ++j) {
      remainder_[i * n + j] = jacobian_.position.mid[i * stride() + j];
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

template <int N>
void CertifiedBlock::find_remainder() {
  const int n = this->n<N>();
  for (int i = 0; i < n; ++i) {
    double* remainder = &remainder_[i * n];
    for (int j = 0; j < n; ++j) remainder[j] = i == j;
    for (int r = 0; r < n; ++r) {
      const double y = inverse_[i * n + r];
      const double* row = &jacobian_.position.mid[r * stride()];
      for (int j = 0; j < n; ++j) remainder[j] -= y * row[j];
    }
    for (int j = 0; j < n; ++j) remainder[j] = std::abs(remainder[j]);
    remainder[i] += rounding_;  // what is left of 1 was rounded
  }
}

/// Writes −Y times the derivatives.
template <int N>
void CertifiedBlock::find_slopes(const IntervalMatrix& derivative,
                                 std::vector<double>& slopes) const {
  const int n = this->n<N>(), w = stride();
  for (int i = 0; i < n; ++i) {
    double* to = &slopes[i * w];
    std::fill_n(to, w, 0);
    for (int r = 0; r < n; ++r) {
      const double y = inverse_[i * n + r];
      const double* from = &derivative.mid[r * w];
      if (y == 0) continue;
#pragma omp simd
      for (int j = 0; j < w; ++j) to[j] -= y * from[j];
    }
  }
}

/// Starts the rows of the unknowns with −Y Φ.
template <int N>
void CertifiedBlock::start(Level level, ErrorRows& to) {
  const int n = this->n<N>();
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

/// Adds −Y (factor × derivative) times the errors of known coordinates at a level. Collects the
/// uncertainty of the derivative times these errors, and all rounding.
template <int N>
void CertifiedBlock::add_image(Level derivative, double factor, Level level,
                               const PerLevel<ErrorRows>& from, ErrorRows& to) {
  const int n = this->n<N>(), w = stride();
  const double* slopes = slopes_[derivative].data();
  const double* mid = jacobian_[derivative].mid.data();
  const double* radius = jacobian_[derivative].radius.data();
  const Errors& e = near_[level];
  const double *e_center = e.center.data(), *e_own = e.own.data(), *e_radius = e.radius.data(),
               *e_sum = e.sum.data();
  for (int i = 0; i < n; ++i, slopes += w, mid += w, radius += w) {
    double center = 0, own = 0, uncertain = 0, rounded = 0;
#pragma omp simd reduction(+ : center, own, uncertain, rounded)
    for (int j = 0; j < w; ++j) {
      center += slopes[j] * e_center[j];
      own += std::abs(slopes[j]) * e_own[j];
      uncertain += radius[j] * e_radius[j];
      rounded += std::abs(mid[j]) * e_sum[j];
    }
    const int row = rows_[i];
    to.center[row] += factor * center;
    to.own[row] += factor * own;
    weights_[i] += factor * (uncertain + rounding_ * rounded);
    if (to.columns == 0) continue;
    double* generators = to.of_row(row);
    for (int j = derivative == Level::position ? n : 0; j < static_cast<int>(rows_.size()); ++j) {
      const double t = factor * slopes[j];
      const double* image = from[level].of_row(rows_[j]);
#pragma omp simd
      for (int k = 0; k < to.columns; ++k) generators[k] += t * image[k];
    }
  }
}

/// Adds |Y| times the uncertainty of the equations to the rows of the unknowns.
template <int N>
void CertifiedBlock::add_uncertainty(ErrorRows& to) {
  const int n = this->n<N>();
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
template <int N>
void CertifiedBlock::contract() {
  const int n = this->n<N>(), w = stride();
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
template <int N>
bool CertifiedBlock::finish(Level level, IntervalState& state, ErrorRows& errors) {
  for (int i = 0; i < n<N>(); ++i) {
    const int row = rows_[i];
    double sum = std::abs(errors.center[row]) + errors.own[row];
    for (int k = 0; k < errors.columns; ++k) sum += std::abs(errors.of_row(row)[k]);
    sum *= 1 + rounding_;
    if (!std::isfinite(sum)) return false;
    errors.sum[row] = errors.radius[row] = sum;
    Errors& e = near_[level];
    e.center[i] = errors.center[row];
    e.own[i] = errors.own[row];
    e.sum[i] = e.radius[i] = sum;
    state[level][equations_.unknowns()[i]].radius = sum;
  }
  return true;
}

/// Finds the errors of positions but for those that X causes: −Y Φ − Y Φ_h δ.
template <int N>
void CertifiedBlock::find_image(PerLevel<ErrorRows>& all) {
  start<N>(Level::position, all.position);
  add_image<N>(Level::position, 1, Level::position, all, all.position);
  add_uncertainty<N>(all.position);
}

template <int N>
bool CertifiedBlock::prove(IntervalState& state, PerLevel<ErrorRows>& all) {
  ErrorRows& errors = all.position;
  gather_inputs(Level::position, errors);
  find_image<N>(all);
  std::ranges::fill(contracted_, 0);
  constexpr int attempts = 6;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    // X is larger than what the last test returned (epsilon inflation; Rump). A part of the
    // magnitude serves errors that are exactly zero.
    for (int i = 0; i < n<N>(); ++i) {
      trial_[i] = 1.1 * (errors.sum[rows_[i]] + contracted_[i]) + 0x1p-60 * magnitudes_[i];
      state.position[equations_.unknowns()[i]].radius = trial_[i];
    }
    if (!equations_.is_linear()) {
      equations_.jacobian(state.position.data(), jacobian_.position);  // the same midpoints
      find_image<N>(all);
    }
    contract<N>();
    bool inside = true;
    for (int i = 0; i < n<N>(); ++i)
      inside = inside && (errors.sum[rows_[i]] + contracted_[i]) * (1 + rounding_) < trial_[i];
    if (!inside) continue;
    for (int i = 0; i < n<N>(); ++i) add_own(errors, i, contracted_[i]);
    return finish<N>(Level::position, state, errors);
  }
  return false;
}

template <int N>
bool CertifiedBlock::bound(Level level, const IntervalState& delivered, IntervalState& state,
                           PerLevel<ErrorRows>& all) {
  ErrorRows& errors = all[level];
  gather_inputs(level, errors);
  start<N>(level, errors);
  add_image<N>(Level::position, 1, level, all, errors);
  if (!equations_.is_linear()) {
    // Φ̇_q and Φ̈_q within the errors of all lower levels, at the delivered rates of this one. Those
    // at lower levels keep their midpoints.
    const bool of_velocity = level == Level::velocity;
    equations_.jacobian_rates(
        {state.position.data(), (of_velocity ? delivered : state).velocity.data(),
         delivered.acceleration.data()},
        level, jacobian_);
    find_slopes<N>(jacobian_[level], slopes_[level]);
    add_image<N>(level, 1, Level::position, all, errors);
    if (!of_velocity) add_image<N>(Level::velocity, 2, Level::velocity, all, errors);
  }
  add_uncertainty<N>(errors);
  // With A = |I − Y Φ_φ(X)| and A r ≤ η r, errors e ≤ b + A e are at most b + A r max(b/r)/(1 − η).
  double ratio = 0, contraction = 0;
  for (int i = 0; i < n<N>(); ++i) {
    ratio = std::max(ratio, errors.sum[rows_[i]] / trial_[i]);
    contraction = std::max(contraction, contracted_[i] / trial_[i]);
  }
  const double margin = 1 - contraction - rounding_;
  if (!(margin > 0)) return false;
  const double factor = ratio / margin * (1 + rounding_);
  for (int i = 0; i < n<N>(); ++i) add_own(errors, i, contracted_[i] * factor);
  return finish<N>(level, state, errors);
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
  inverted_ = with_size([&]<int N>() {
    if (!invert<N>()) return false;
    find_remainder<N>();
    find_slopes<N>(jacobian_.position, slopes_.position);
    return true;
  });
}

bool CertifiedBlock::prove_positions(IntervalState& state, PerLevel<ErrorRows>& errors) {
  return inverted_ && with_size([&]<int N>() { return prove<N>(state, errors); });
}

bool CertifiedBlock::bound_rates(Level level, const IntervalState& delivered, IntervalState& state,
                                 PerLevel<ErrorRows>& errors) {
  return with_size([&]<int N>() { return bound<N>(level, delivered, state, errors); });
}

}  // namespace desmo
