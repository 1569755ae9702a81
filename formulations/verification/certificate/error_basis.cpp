#include "formulations/verification/certificate/error_basis.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/certificate/interval.h"

namespace desmo {

ErrorBasis::ErrorBasis(int max_errors, int max_columns)
    : generators_(max_errors * max_columns),
      own_(max_errors),
      scale_(max_errors),
      basis_(max_errors * max_errors),
      radii_(max_errors),
      rest_(max_errors * max_columns),
      sums_(max_columns) {}

void ErrorBasis::start(int errors, int columns) {
  size_ = errors;
  columns_ = columns;
}

void ErrorBasis::set(int i, const double* generators, double own, int rank) {
  double sum = own;
  for (int k = 0; k < columns_; ++k) sum += std::abs(generators[k]);
  int exponent = 0;
  if (sum > 1e-200) std::frexp(sum, &exponent);
  constexpr int between_ranks = 10;
  scale_[i] = std::ldexp(1.0, -exponent - between_ranks * rank);
  own_[i] = own * scale_[i];
  for (int k = 0; k < columns_; ++k) generators_[i * columns_ + k] = generators[k] * scale_[i];
}

/// Gram–Schmidt with pivoting: the longest column of G first, and so on with what is left of them.
void ErrorBasis::find_directions() {
  const int d = size_, n = columns_;
  std::copy_n(generators_.begin(), d * n, rest_.begin());
  for (int s = 0, unit = 0; s < d; ++s) {
    std::fill_n(sums_.begin(), n, 0);
    for (int i = 0; i < d; ++i)
      for (int k = 0; k < n; ++k) sums_[k] += rest_[i * n + k] * rest_[i * n + k];
    const auto longest = std::max_element(sums_.begin(), sums_.begin() + n);
    constexpr double negligible = 1e-30;  // of rows of size 1
    const bool is_rest = n > 0 && *longest > negligible;
    for (int i = 0; i < d; ++i)
      basis_[i * d + s] =
          is_rest ? rest_[i * n + (longest - sums_.begin())] / std::sqrt(*longest) : i == unit;
    unit += !is_rest;
    for (bool again = true; again;) {
      for (int before = 0; before < s; ++before) {
        double along = 0;
        for (int i = 0; i < d; ++i) along += basis_[i * d + before] * basis_[i * d + s];
        for (int i = 0; i < d; ++i) basis_[i * d + s] -= along * basis_[i * d + before];
      }
      double length = 0;
      for (int i = 0; i < d; ++i) length += basis_[i * d + s] * basis_[i * d + s];
      again = length < 0x1p-20 && unit < d;  // depends on those before: another direction
      length = again ? 1 : 1 / std::sqrt(length);
      for (int i = 0; i < d; ++i)
        basis_[i * d + s] = again ? i == unit : basis_[i * d + s] * length;
      unit += again;
    }
    std::fill_n(sums_.begin(), n, 0);
    for (int i = 0; i < d; ++i)
      for (int k = 0; k < n; ++k) sums_[k] += basis_[i * d + s] * rest_[i * n + k];
    for (int i = 0; i < d; ++i)
      for (int k = 0; k < n; ++k) rest_[i * n + k] -= basis_[i * d + s] * sums_[k];
  }
}

/// Returns a bound on ‖I − QᵀQ‖∞, and on the rounding of Qᵀ G relative to the widest radius.
double ErrorBasis::deviation() const {
  const int d = size_;
  double worst = 0;
  for (int s = 0; s < d; ++s) {
    double sum = 0;
    for (int r = 0; r < d; ++r) {
      double product = s == r ? -1 : 0;
      for (int i = 0; i < d; ++i) product += basis_[i * d + s] * basis_[i * d + r];
      sum += std::abs(product);
    }
    worst = std::max(worst, sum);
  }
  // Each product is a sum of d + 1 terms, whose magnitudes add up to little more than 2. That takes
  // half of this; the other half covers the rounding of Qᵀ G. The error of each of its columns is
  // at most d unit |Qᵀ| |G|, and the rows of |G| have sums of at most √d times the widest radius,
  // since all errors are Q s; so those of a column of Q add up to d² unit times it. More than 4 d
  // units are left, of which the rounding of radii and of generator() takes 3.
  return worst + 4 * d * (d + 2) * Interval::unit;
}

void ErrorBasis::enclose() {
  find_directions();
  // The errors are Q s for s = Q⁻¹ (G t + w), and Q⁻¹ = (QᵀQ)⁻¹ Qᵀ.
  const int d = size_, n = columns_;
  const double rounding = 4 * (d + n + 8) * Interval::unit;
  double widest = 0;
  for (int s = 0; s < d; ++s) {
    std::fill_n(sums_.begin(), n, 0);
    double own = 0;
    for (int i = 0; i < d; ++i) {
      const double q = basis_[i * d + s];
      for (int k = 0; k < n; ++k) sums_[k] += q * generators_[i * n + k];
      own += std::abs(q) * own_[i];
    }
    for (int k = 0; k < n; ++k) own += std::abs(sums_[k]);
    radii_[s] = own * (1 + rounding) + Interval::tiny;
    widest = std::max(widest, radii_[s]);
  }
  const double off = deviation();
  const double correction = off < 0.5 ? off / (1 - off) * 1.0001 * widest : INFINITY;
  for (int s = 0; s < d; ++s) radii_[s] += correction;
}

}  // namespace desmo
