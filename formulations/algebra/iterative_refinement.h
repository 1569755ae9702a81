#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "formulations/equations/pattern.h"

namespace desmo {

/// Iterative refinement: solves Φ_φ x = b with factors of a nearby matrix (of another position, or
/// with fewer digits) as accurately as with factors of Φ_φ itself. Accuracy is the backward error
/// max w |b − Φ_φ x| / max w (|b| + |Φ_φ| |x|). The weight w is 1/magnitude of each equation, as in
/// the norm that accepts positions.
template <class Real>
class IterativeRefinement {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  /// weights: w, referenced for the lifetime of this object. used: false allocates nothing.
  IterativeRefinement(const Vector& weights, bool used)
      : weights_(weights),
        right_(used ? weights.size() : 0),
        residual_(right_.size()),
        size_(right_.size()) {}

  /// Solves Φ_φ x = b. Returns true when the error is down to a few units of rounding. Returns
  /// false, with b in x again, as soon as the remaining sweeps cannot get there.
  /// - solve_by_factors(Real* b): overwrites b with the solution by the factors at hand
  /// - sweeps: most corrections to make
  /// - x: b on entry, the solution on return
  template <class Solve>
  bool solve(const Pattern& pattern, const Real* values, Solve solve_by_factors, int sweeps,
             Vector& x) {
    constexpr Real wanted = 16 * std::numeric_limits<Real>::epsilon();
    right_ = x;
    solve_by_factors(x.data());
    Real error = backward_error(pattern, values, x);
    for (Real rate = 0; !(error <= wanted); --sweeps) {
      if (sweeps <= 0 || !(error * std::pow(rate, Real(sweeps)) <= wanted)) {
        x = right_;
        return false;
      }
      solve_by_factors(residual_.data());
      x += residual_;
      const Real before = error;
      error = backward_error(pattern, values, x);
      rate = error / before;
    }
    return true;
  }

 private:
  /// Writes b − Φ_φ x to residual_. Returns the backward error.
  Real backward_error(const Pattern& p, const Real* values, const Vector& x) {
    residual_ = right_;
    size_ = right_.cwiseAbs();
    for (int j = 0; j < p.n; ++j)
      for (int k = p.column_start[j]; k < p.column_start[j + 1]; ++k) {
        const Real term = values[k] * x[j];
        residual_[p.row[k]] -= term;
        size_[p.row[k]] += std::abs(term);
      }
    const Real size = weights_.cwiseProduct(size_).maxCoeff();
    if (size == 0) return 0;  // b and x are nothing
    return weights_.cwiseProduct(residual_).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>() /
           size;
  }

  const Vector& weights_;
  Vector right_, residual_, size_;
};

}  // namespace desmo
