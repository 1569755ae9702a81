// Dense LU with partial pivoting by Eigen.

// Eigen keeps the packed blocks of its matrix products on the stack up to this size, and on the
// heap, where the timed loop must not be, beyond it.
#define EIGEN_STACK_ALLOCATION_LIMIT (4 * 1024 * 1024)
#include <Eigen/LU>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/dense.h"

namespace desmo {

namespace {

class EigenLu {
 public:
  static constexpr bool keeps_pivots = false;

  explicit EigenLu(const Pattern& pattern)
      : scatter_(pattern), matrix_(pattern.n, pattern.n), lu_(pattern.n), x_(pattern.n) {}

  bool factor(const double* values) {
    scatter_(values, matrix_.data());
    lu_.compute(matrix_);
    return (lu_.matrixLU().diagonal().array() != 0).all();
  }

  void solve(double* b) {
    Eigen::Map<Eigen::VectorXd> right(b, x_.size());
    x_ = lu_.solve(right);
    right = x_;
  }

 private:
  DenseScatter scatter_;
  Eigen::MatrixXd matrix_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::VectorXd x_;
};

}  // namespace

extern const Backend eigen_backend;
const Backend eigen_backend{"eigen", true, &make_newton_part<EigenLu>, [] {
                              return std::to_string(EIGEN_WORLD_VERSION) + "." +
                                     std::to_string(EIGEN_MAJOR_VERSION) + "." +
                                     std::to_string(EIGEN_MINOR_VERSION);
                            }};

}  // namespace desmo
