#include "formulations/modelling/independence/row_space.h"

namespace desmo {

bool RowSpace::add(Eigen::VectorXd row) {
  if (rank_ == basis_.cols()) return false;
  for (int pass = 0; pass < 2; ++pass)  // the second removes what rounding left
    row -= basis_.leftCols(rank_) * (basis_.leftCols(rank_).transpose() * row);
  const double rest = row.norm();
  if (!(rest > dependent_below)) return false;
  basis_.col(rank_++) = row / rest;
  return true;
}

SmallestCorrection::SmallestCorrection(const Eigen::MatrixXd& jacobian) {
  decomposition_.setThreshold(dependent_below);
  decomposition_.compute(jacobian);
}

Eigen::VectorXd SmallestCorrection::operator()(const Eigen::VectorXd& phi) const {
  return decomposition_.solve(phi);
}

}  // namespace desmo
