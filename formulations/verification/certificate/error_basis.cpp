#include "formulations/verification/certificate/error_basis.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/certificate/interval.h"

namespace desmo {

ErrorBasis::ErrorBasis(int d, int columns)
    : d_(d), q_(d * d), sigma_(d), rest_(d * columns), sums_(std::max(columns, d)) {}

void ErrorBasis::enclose_box(const double* radii, const std::vector<int>& rows) {
  std::ranges::fill(q_, 0);
  for (int s = 0; s < d_; ++s) {
    q_[s * d_ + s] = 1;
    sigma_[s] = std::isfinite(radii[rows[s]]) ? radii[rows[s]] : 0;
  }
}

/// Gram–Schmidt with pivoting: the longest generator first, and so on with what is left of them.
void ErrorBasis::find_directions(const Generators& g) {
  for (int i = 0; i < d_; ++i)
    std::copy_n(g.values + g.rows[i] * g.columns, g.columns, rest_.begin() + i * g.columns);
  for (int s = 0; s < d_; ++s) {
    std::fill_n(sums_.begin(), g.columns, 0);
    for (int i = 0; i < d_; ++i)
      for (int k = 0; k < g.columns; ++k)
        sums_[k] += rest_[i * g.columns + k] * rest_[i * g.columns + k];
    const int pivot = static_cast<int>(std::max_element(sums_.begin(), sums_.begin() + g.columns) -
                                       sums_.begin());
    double length = g.columns > 0 ? std::sqrt(sums_[pivot]) : 0;
    for (int i = 0; i < d_; ++i)
      q_[i * d_ + s] = length > 0 ? rest_[i * g.columns + pivot] / length : i == s;
    for (int unit = 0, pass = 0; pass < 2; ++pass) {  // twice is enough (Parlett)
      for (int before = 0; before < s; ++before) {
        double along = 0;
        for (int i = 0; i < d_; ++i) along += q_[i * d_ + before] * q_[i * d_ + s];
        for (int i = 0; i < d_; ++i) q_[i * d_ + s] -= along * q_[i * d_ + before];
      }
      length = 0;
      for (int i = 0; i < d_; ++i) length += q_[i * d_ + s] * q_[i * d_ + s];
      if (length < 0x1p-20 && unit < d_) {  // depends on those before: any other direction
        for (int i = 0; i < d_; ++i) q_[i * d_ + s] = i == unit;
        ++unit;
        pass = -1;
        continue;
      }
      for (int i = 0; i < d_; ++i) q_[i * d_ + s] /= std::sqrt(length);
    }
    std::fill_n(sums_.begin(), g.columns, 0);
    for (int i = 0; i < d_; ++i)
      for (int k = 0; k < g.columns; ++k) sums_[k] += q_[i * d_ + s] * rest_[i * g.columns + k];
    for (int i = 0; i < d_; ++i)
      for (int k = 0; k < g.columns; ++k) rest_[i * g.columns + k] -= q_[i * d_ + s] * sums_[k];
  }
}

/// Returns a bound on ‖I − QᵀQ‖∞.
double ErrorBasis::deviation() const {
  double worst = 0;
  for (int s = 0; s < d_; ++s) {
    double sum = 0;
    for (int r = 0; r < d_; ++r) {
      double product = s == r ? -1 : 0;
      for (int i = 0; i < d_; ++i) product += q_[i * d_ + s] * q_[i * d_ + r];
      sum += std::abs(product);
    }
    worst = std::max(worst, sum);
  }
  return worst + 4 * d_ * (d_ + 2) * Interval::unit;  // |q| ≤ 1 + small: rounding of the products
}

void ErrorBasis::enclose(const Generators& g) {
  if (d_ == 1)
    q_[0] = 1;
  else
    find_directions(g);
  // The errors are Q s for s = Q⁻¹ G t, and Q⁻¹ = (QᵀQ)⁻¹ Qᵀ.
  const double rounding = (2 * d_ + g.columns + 8) * 2 * Interval::unit;
  double widest = 0;
  for (int s = 0; s < d_; ++s) {
    std::fill_n(sums_.begin(), g.columns, 0);
    double rounded = 0;  // Σ |Q| |G|, of whose products each is rounded
    for (int i = 0; i < d_; ++i) {
      const double q = q_[i * d_ + s];
      const double* row = g.values + g.rows[i] * g.columns;
      double sum = 0;
      for (int k = 0; k < g.columns; ++k) {
        sums_[k] += q * row[k];
        sum += std::abs(row[k]);
      }
      rounded += std::abs(q) * sum;
    }
    double sigma = 0;
    for (int k = 0; k < g.columns; ++k) sigma += std::abs(sums_[k]);
    sigma_[s] = (sigma + rounding * rounded) * (1 + rounding) + Interval::tiny;
    widest = std::max(widest, sigma_[s]);
  }
  if (d_ == 1) return;
  const double off = deviation();
  const double correction =
      off < 0.5 ? off / (1 - off) * (1 + 8 * Interval::unit) * widest : INFINITY;
  for (double& sigma : sigma_) sigma = (sigma + correction) * (1 + 4 * Interval::unit);
}

}  // namespace desmo
