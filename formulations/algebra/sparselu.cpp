// Sparse LU by Eigen (supernodal, with partial pivoting). Ordering and column elimination tree are
// found once. Every factorisation pivots anew; factorisations and solutions allocate.

#include <Eigen/SparseLU>
#include <algorithm>

#include "formulations/algebra/backend.h"

namespace desmo {

namespace {

class SparseLu final : public LinearSolver {
 public:
  explicit SparseLu(const Pattern& pattern) : matrix_(pattern.n, pattern.n), x_(pattern.n) {
    matrix_.resizeNonZeros(static_cast<Eigen::Index>(pattern.row.size()));
    std::ranges::copy(pattern.column_start, matrix_.outerIndexPtr());
    std::ranges::copy(pattern.row, matrix_.innerIndexPtr());
    matrix_.coeffs().setOnes();
    lu_.analyzePattern(matrix_);
  }

  bool factor(const double* values) override {
    std::copy_n(values, matrix_.nonZeros(), matrix_.valuePtr());
    lu_.factorize(matrix_);
    return lu_.info() == Eigen::Success;
  }

  void solve(double* b) override {
    Eigen::Map<Eigen::VectorXd> right(b, x_.size());
    x_ = lu_.solve(right);
    right = x_;
  }

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  Matrix matrix_;
  Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> lu_;
  Eigen::VectorXd x_;
};

}  // namespace

extern const Backend sparselu_backend{
    .name = "sparselu",
    .make_solver = &make_solver<SparseLu>,
    .version =
        [] { return version_text(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION); },
    .allocates = true,
    .slow_blocks_reason = slow_in_blocks};

}  // namespace desmo
