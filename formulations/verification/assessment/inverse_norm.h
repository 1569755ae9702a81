#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace desmo {

/// Largest row of an inverse, and the unknown that attains it.
struct WorstCase {
  double value = 0;
  int unknown = 0;  ///< row that attains it
};

/// Estimates max w |A⁻¹| f = ‖W A⁻¹ F‖∞ from a few solutions with A and Aᵀ. W and F are diagonal
/// and not negative. The rows tried are exact; the result is hardly ever less than a third of the
/// maximum (Higham, algorithm 15.1, LAPACK's xLACN2, used as in xGERFS). The search starts from the
/// last worst unknown, which mostly is the worst again.
class InverseNorm {
 public:
  explicit InverseNorm(int n) : x_(n, 2), sign_(n) {}

  /// Returns the estimate of max w |A⁻¹| f, and where it is attained. factors: solve(x) overwrites
  /// x with A⁻¹ x, and solve_transposed(x, columns) overwrites an array of columns with A⁻ᵀ of
  /// each.
  template <class Factors>
  WorstCase operator()(Factors& factors, const Eigen::ArrayXd& w, const Eigen::ArrayXd& f) {
    const Eigen::Index n = sign_.size();
    WorstCase worst;
    if (n == 0) return worst;
    auto x = x_.col(0), alternating = x_.col(1);
    const auto solve_rows = [&](int count) {  // F A⁻ᵀ W x; turns eⱼ into row j of W A⁻¹ F
      x_.leftCols(count).colwise() *= w;
      factors.solve_transposed(x_.data(), count);
      x_.leftCols(count).colwise() *= f;
    };
    int tried = last_worst_;
    bool is_attained = tried >= 0;
    x.setConstant(is_attained ? 0 : 1.0 / static_cast<double>(n));
    if (is_attained) x[tried] = 1;
    for (Eigen::Index i = 0; i < n; ++i)
      alternating[i] =
          (i % 2 == 0 ? 1 : -1) * (1 + static_cast<double>(i) / static_cast<double>(n));
    solve_rows(2);
    worst = {x.abs().sum(), std::max(tried, 0)};
    // Alternating, growing numbers reveal a large row that cancellation has hidden from the search.
    const double hidden = 2 * alternating.abs().sum() / (3 * static_cast<double>(n));
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
      sign_ = (x < 0).select(Eigen::ArrayXd::Constant(n, -1.0), 1.0);
      x = f * sign_;
      factors.solve(x_.data());
      x *= w;
      Eigen::Index j = 0;
      x.abs().maxCoeff(&j);
      if (j == tried) break;
      tried = static_cast<int>(j);
      x.setZero();
      x[j] = 1;
      solve_rows(1);
      const double value = x.abs().sum();
      const bool grows = !(value <= worst.value);
      if (!is_attained || grows) worst.unknown = tried;
      if (grows) worst.value = value;
      if (!grows && is_attained) break;
      is_attained = true;
    }
    last_worst_ = worst.unknown;
    if (!(hidden <= worst.value)) worst.value = hidden;
    return worst;
  }

 private:
  static constexpr int max_attempts = 5;

  Eigen::ArrayX2d x_;
  Eigen::ArrayXd sign_;
  int last_worst_ = -1;
};

}  // namespace desmo
