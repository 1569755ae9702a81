#pragma once

#include <Eigen/Core>
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
  explicit InverseNorm(int n) : x_(n), sign_(n) {}

  /// Returns the estimate. factors: solve(x) and solve_transposed(x) overwrite x with A⁻¹ x and
  /// A⁻ᵀ x.
  template <class Factors>
  WorstCase operator()(Factors& factors, const Eigen::ArrayXd& w, const Eigen::ArrayXd& f) {
    const Eigen::Index n = x_.size();
    WorstCase worst;
    if (n == 0) return worst;
    const auto row = [&] {  // x = F A⁻ᵀ W x; turns eⱼ into row j of W A⁻¹ F
      x_ *= w;
      factors.solve_transposed(x_.data());
      x_ *= f;
      return x_.abs().sum();
    };
    const auto row_of = [&](Eigen::Index j) {
      x_.setZero();
      x_[j] = 1;
      return row();
    };
    int tried = last_worst_;
    bool is_attained = tried >= 0;
    if (is_attained) {
      worst = {row_of(tried), tried};
    } else {
      x_.setConstant(1.0 / static_cast<double>(n));
      worst.value = row();
    }
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
      sign_ = (x_ < 0).select(Eigen::ArrayXd::Constant(n, -1.0), 1.0);
      x_ = f * sign_;
      factors.solve(x_.data());
      x_ *= w;
      Eigen::Index j = 0;
      x_.abs().maxCoeff(&j);
      if (j == tried) break;
      tried = static_cast<int>(j);
      const double value = row_of(j);
      const bool grows = !(value <= worst.value);
      if (!is_attained || grows) worst.unknown = tried;
      if (grows) worst.value = value;
      if (!grows && is_attained) break;
      is_attained = true;
    }
    last_worst_ = worst.unknown;
    // Alternating, growing numbers reveal a large row that cancellation has hidden from the search.
    for (Eigen::Index i = 0; i < n; ++i)
      x_[i] = (i % 2 == 0 ? 1 : -1) * (1 + static_cast<double>(i) / static_cast<double>(n));
    const double value = 2 * row() / (3 * static_cast<double>(n));
    if (!(value <= worst.value)) worst.value = value;
    return worst;
  }

 private:
  static constexpr int max_attempts = 5;

  Eigen::ArrayXd x_, sign_;
  int last_worst_ = -1;
};

}  // namespace desmo
