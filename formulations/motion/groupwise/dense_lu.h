#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace desmo {

/// LU factorisation with partial pivoting of a small dense matrix, in any scalar S. Solutions with
/// a singular matrix are not finite.
template <class S>
class DenseLu {
 public:
  /// a: (n × n) by rows, factorised in place.
  DenseLu(std::vector<S> a, std::size_t n) : a_(std::move(a)), n_(n), pivot_(n) {
    using std::abs;
    for (std::size_t k = 0; k < n_; ++k) {
      std::size_t p = k;
      for (std::size_t i = k + 1; i < n_; ++i)
        if (abs(at(i, k)) > abs(at(p, k))) p = i;
      pivot_[k] = p;
      if (p != k)
        for (std::size_t j = 0; j < n_; ++j) std::swap(at(k, j), at(p, j));
      for (std::size_t i = k + 1; i < n_; ++i) {
        const S factor = at(i, k) /= at(k, k);
        if (factor == S(0)) continue;
        for (std::size_t j = k + 1; j < n_; ++j) at(i, j) -= factor * at(k, j);
      }
    }
  }

  /// Determinant of a: its sign, and the natural logarithm of its magnitude.
  struct Determinant {
    int sign = 1;
    double log = 0;
  };
  Determinant determinant() const {
    Determinant d;
    for (std::size_t k = 0; k < n_; ++k) {
      if ((at(k, k) < S(0)) != (pivot_[k] != k)) d.sign = -d.sign;
      d.log += std::log(std::abs(static_cast<double>(at(k, k))));
    }
    return d;
  }

  /// Returns a⁻¹ b.
  std::vector<S> solve(std::vector<S> b) const {
    for (std::size_t k = 0; k < n_; ++k) std::swap(b[k], b[pivot_[k]]);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j) b[i] -= at(i, j) * b[j];
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) b[i] -= at(i, j) * b[j];
      b[i] /= at(i, i);
    }
    return b;
  }

 private:
  S& at(std::size_t i, std::size_t j) { return a_[i * n_ + j]; }
  const S& at(std::size_t i, std::size_t j) const { return a_[i * n_ + j]; }

  std::vector<S> a_;  // U on and above the diagonal, below it L, whose diagonal is 1
  std::size_t n_;
  std::vector<std::size_t> pivot_;  // [k]: row exchanged with row k
};

}  // namespace desmo
