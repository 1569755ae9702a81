#pragma once

#include <Eigen/QR>

namespace desmo {

/// What has to be left of a row of length 1, beside others, for it not to depend on them.
inline constexpr double dependent_below = 1e-6;

/// Rows chosen one by one, each if it is independent of those before.
class RowSpace {
 public:
  explicit RowSpace(int columns) : basis_(columns, columns) {}

  /// Whether a row of length at most 1 is new; if so it joins.
  bool add(Eigen::VectorXd row);
  int rank() const { return rank_; }

 private:
  Eigen::MatrixXd basis_;
  int rank_ = 0;
};

/// The smallest corrections that make linear equations hold, those that depend on others included
/// and as far as they can hold together.
class SmallestCorrection {
 public:
  explicit SmallestCorrection(const Eigen::MatrixXd& jacobian);
  Eigen::VectorXd operator()(const Eigen::VectorXd& phi) const;

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
};

}  // namespace desmo
