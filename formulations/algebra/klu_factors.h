#pragma once

#include <klu.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "formulations/algebra/linear_solver.h"
#include "formulations/base/settings.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Sparse LU factorisation by SuiteSparse's KLU, for the algebra `klu` and for ScaledFactors.
/// Block triangular form (optional) and ordering are found once. Later factorisations reuse the
/// pivot order while its pivots stay good.
class KluFactors final : public LinearSolver {
 public:
  explicit KluFactors(const Pattern& pattern, BlockTriangularForm btf = BlockTriangularForm::on)
      : n_(pattern.n), start_(pattern.column_start), row_(pattern.row) {
    klu_defaults(&common_);
    common_.btf = btf == BlockTriangularForm::on;
    common_.scale = -1;  // row scaling costs a tenth of the time, and these matrices need none
    // A pivot order has to last. With the default of 0.001 a pivot may be so small that the motion
    // takes it through zero.
    common_.tol = 0.1;
    symbolic_ = klu_analyze(n_, start_.data(), row_.data(), &common_);
    if (!symbolic_) throw std::invalid_argument("KLU: the Jacobian is structurally singular");
  }
  ~KluFactors() override {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }

  bool factor(const double* values) override {
    double* ax = const_cast<double*>(values);  // KLU reads them only
    if (numeric_ && klu_refactor(start_.data(), row_.data(), ax, symbolic_, numeric_, &common_) &&
        pivots_are_good())
      return true;
    forget_pivots();
    ++pivot_choices_;
    numeric_ = klu_factor(start_.data(), row_.data(), ax, symbolic_, &common_);
    return numeric_ && common_.status == KLU_OK;
  }

  void solve(double* b) override { klu_solve(symbolic_, numeric_, n_, 1, b, &common_); }

  Pivots pivots() const override { return {.reuse_order = true, .choices = pivot_choices_}; }

  void forget_pivots() override { klu_free_numeric(&numeric_, &common_); }

  /// Returns the first row of each irreducible block, in permuted order, and the end of the last.
  std::span<const int> block_start() const {
    return {symbolic_->R, static_cast<std::size_t>(symbolic_->nblocks) + 1};
  }

 private:
  Eigen::Map<const Eigen::ArrayXd> pivot_array() const {
    return {static_cast<const double*>(numeric_->Udiag), n_};
  }

  /// Returns whether the smallest pivot is large enough compared with the largest (klu_rcond). The
  /// bound is SUNDIALS'.
  bool pivots_are_good() const {
    static const double min_ratio = std::pow(std::numeric_limits<double>::epsilon(), 2.0 / 3.0);
    const auto size = pivot_array().abs();
    return size.minCoeff() > min_ratio * size.maxCoeff();
  }

  int n_;
  std::vector<int> start_, row_;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  long pivot_choices_ = 0;
};

}  // namespace desmo
