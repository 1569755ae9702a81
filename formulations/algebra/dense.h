#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Writes a part's Φ_φ into a dense matrix, stored by columns.
class DenseScatter {
 public:
  explicit DenseScatter(const Pattern& pattern) : n_(pattern.n) {
    for (int j = 0; j < n_; ++j)
      for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k)
        position_.push_back(j * n_ + pattern.row[k]);
  }

  /// Overwrites matrix (n × n, by columns).
  template <class Real, class Factor>
  void operator()(const Real* values, Factor* matrix) const {
    std::fill_n(matrix, static_cast<std::size_t>(n_) * n_, Factor(0));
    for (const int p : position_) matrix[p] = static_cast<Factor>(*values++);
  }

  int n() const { return n_; }

 private:
  int n_;
  std::vector<int> position_;  // position of each pattern entry in the matrix
};

/// Dense LU solver. Its factors are in the precision Factor, its input and output in Real. Lu has
///   explicit Lu(int n)
///   Factor* matrix()      n × n by columns, to be written before factor()
///   bool factor()         overwrites the matrix; false when singular
///   void solve(Factor* b) b = A⁻¹ b
template <class Real, class Factor, template <class> class Lu>
class Dense final : public LinearSolver<Real> {
 public:
  explicit Dense(const Pattern& pattern)
      : scatter_(pattern), lu_(pattern.n), rounded_(rounds ? pattern.n : 0) {}

  bool factor(const Real* values) override {
    scatter_(values, lu_.matrix());
    return lu_.factor();
  }

  void solve(Real* b) override {
    if constexpr (rounds) {
      // Right-hand sides may be beyond what Factor can hold, and corrections become tiny.
      Real largest = 0;
      for (int i = 0; i < scatter_.n(); ++i) largest = std::max(largest, std::abs(b[i]));
      if (!(largest > 0) || !std::isfinite(largest)) return;
      for (int i = 0; i < scatter_.n(); ++i) rounded_[i] = static_cast<Factor>(b[i] / largest);
      lu_.solve(rounded_.data());
      for (int i = 0; i < scatter_.n(); ++i) b[i] = largest * static_cast<Real>(rounded_[i]);
    } else {
      lu_.solve(b);
    }
  }

  /// Returns n/6, at least 3: LU takes n/3 times the operations of a solve, at about twice the
  /// speed.
  int break_even_solves() const override { return std::max(3, scatter_.n() / 6); }

  bool rounds_factors() const override { return rounds; }

 private:
  static constexpr bool rounds = !std::is_same_v<Real, Factor>;

  DenseScatter scatter_;
  Lu<Factor> lu_;
  std::vector<Factor> rounded_;
};

/// Makes a dense LU solver, with double or single factors.
template <template <class> class Lu>
std::unique_ptr<LinearSolver<double>> make_dense_solver(const Pattern& pattern,
                                                        const Settings& settings) {
  if (settings.scalar == Scalar::mixed) return std::make_unique<Dense<double, float, Lu>>(pattern);
  return std::make_unique<Dense<double, double, Lu>>(pattern);
}

/// Makes a dense LU solver of single precision.
template <template <class> class Lu>
std::unique_ptr<LinearSolver<float>> make_single_dense_solver(const Pattern& pattern) {
  return std::make_unique<Dense<float, float, Lu>>(pattern);
}

}  // namespace desmo
