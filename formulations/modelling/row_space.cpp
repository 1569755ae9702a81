#include "formulations/modelling/row_space.h"

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

Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decompose(const Eigen::MatrixXd& jacobian) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(dependent_below);
  decomposition.compute(jacobian);
  return decomposition;
}

}  // namespace desmo
