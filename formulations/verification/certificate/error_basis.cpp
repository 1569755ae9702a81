#include "formulations/verification/certificate/error_basis.h"

#include <algorithm>
#include <cmath>

#include "cases/numbers/interval.h"

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

void ErrorBasis::set(int i, const double* generators, double own) {
  double sum = own;
  for (int k = 0; k < columns_; ++k) sum += std::abs(generators[k]);
  int exponent = 0;
  std::frexp(sum, &exponent);
  scale_[i] = std::ldexp(1.0, -exponent);
  own_[i] = own * scale_[i];
  for (int k = 0; k < columns_; ++k) generators_[i * columns_ + k] = generators[k] * scale_[i];
}

/// Finds Q by Gram–Schmidt with pivoting. The longest column of G gives the first direction, the
/// longest column of what is then left of G the next one.
void ErrorBasis::find_directions() {
  const int d = size_, n = columns_;
  std::copy_n(generators_.begin(), d * n, rest_.begin());
  for (int s = 0, unit = 0; s < d; ++s) {
    std::fill_n(sums_.begin(), n, 0);
    for (int i = 0; i < d; ++i)
      for (int k = 0; k < n; ++k) sums_[k] += rest_[i * n + k] * rest_[i * n + k];
    const auto longest = std::max_element(sums_.begin(), sums_.begin() + n);
    const bool is_rest = n > 0 && *longest > 0;
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
      // A direction depends on earlier ones if less than 1/(2 d) of its squared length is left.
      // The next unit vector then replaces it. One always serves: the squared lengths that
      // are left of all d unit vectors sum to d − s ≥ 1, those of rejected ones to less than 1/2.
      again = length * (2 * d) < 1 && unit < d;
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

double ErrorBasis::deviation(std::span<const double> q, int d) {
  double worst = 0;
  for (int s = 0; s < d; ++s) {
    double sum = 0;
    for (int r = 0; r < d; ++r) {
      double product = s == r ? -1 : 0;
      for (int i = 0; i < d; ++i) product += q[i * d + s] * q[i * d + r];
      sum += std::abs(product);
    }
    worst = std::max(worst, sum);
  }
  // In units of roundoff:
  // - QᵀQ: (d + 1)². Each row has d sums of d + 1 terms, whose magnitudes add up to d + 1.
  // - Qᵀ G: d². The error of each column is at most d |Qᵀ| |G|. Rows of |G| have sums of at most √d
  //   times the widest radius, since all errors are Q s; columns of |Q| have sums of at most √d.
  // - the errors' own radii, d products: d + 1; `sum` above: d
  // - adding this correction, its quotient, its product and generator(): less than 4
  return worst + 4 * d * (d + 2) * Interval::unit;
}

void ErrorBasis::enclose() {
  find_directions();
  // The scaled errors are Q s for s = Q⁻¹ (G t + own w), and Q⁻¹ = (QᵀQ)⁻¹ Qᵀ.
  const int d = size_, n = columns_;
  double widest = 0;
  for (int s = 0; s < d; ++s) {
    std::fill_n(sums_.begin(), n, 0);
    double radius = 0;
    for (int i = 0; i < d; ++i) {
      const double q = basis_[i * d + s];
      for (int k = 0; k < n; ++k) sums_[k] += q * generators_[i * n + k];
      radius += std::abs(q) * own_[i];
    }
    for (int k = 0; k < n; ++k) radius += std::abs(sums_[k]);
    radii_[s] = radius * (1 + 2 * n * Interval::unit);
    widest = std::max(widest, radii_[s]);
  }
  // With off = ‖I − QᵀQ‖∞, (QᵀQ)⁻¹ differs from I by at most off / (1 − off).
  const double off = deviation(basis_, d);
  const double correction = off < 1 ? off / (1 - off) * widest : INFINITY;
  for (int s = 0; s < d; ++s) radii_[s] += correction;
}

}  // namespace desmo
