// Dense LU with partial pivoting by Eigen.

#include <Eigen/LU>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/dense.h"

namespace desmo {

namespace {

class EigenLu {
 public:
  explicit EigenLu(int n) : matrix_(n, n), lu_(n), x_(n) {}

  double* matrix() { return matrix_.data(); }

  bool factor() {
    lu_.compute(matrix_);
    return (lu_.matrixLU().diagonal().array() != 0).all();
  }

  void solve(double* b) {
    Eigen::Map<Eigen::VectorXd> right(b, x_.size());
    x_ = lu_.solve(right);
    right = x_;
  }

 private:
  Eigen::MatrixXd matrix_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::VectorXd x_;
};

}  // namespace

extern const Backend eigen_backend{
    .name = "eigen", .dense = true, .make_solver = &make_solver<Dense<EigenLu>>, .version = [] {
      return version_text(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
    }};

}  // namespace desmo
