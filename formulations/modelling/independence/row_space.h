#pragma once

#include <Eigen/QR>

namespace desmo {

/// A row of length 1 depends on others when its component orthogonal to them is not longer than
/// this.
inline constexpr double dependent_below = 1e-6;

/// The span of independent rows, added one by one.
class RowSpace {
 public:
  explicit RowSpace(int columns) : basis_(columns, columns) {}

  /// Adds a row of length ≤ 1 if it is independent of the rows before. Returns whether it was.
  bool add(Eigen::VectorXd row);
  int rank() const { return rank_; }

 private:
  Eigen::MatrixXd basis_;
  int rank_ = 0;
};

/// The minimum-norm least-squares solution x of J x = φ, which also serves dependent equations.
class SmallestCorrection {
 public:
  explicit SmallestCorrection(const Eigen::MatrixXd& jacobian);
  /// Returns x (columns of J).
  Eigen::VectorXd operator()(const Eigen::VectorXd& phi) const;

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
};

}  // namespace desmo
