#pragma once

#include <klu.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "formulations/algebra/linear_solver.h"
#include "formulations/base/settings.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Sparse LU factorisation by SuiteSparse's KLU. Block triangular form (optional) and ordering are
/// found once. Later factorisations reuse the pivot order while its pivots stay good. NewtonSolver
/// and the assessment of solved instants use it.
class KluFactors final : public LinearSolver<double> {
 public:
  explicit KluFactors(const Pattern& pattern, BlockTriangularForm btf = BlockTriangularForm::on)
      : n_(pattern.n), start_(pattern.column_start), row_(pattern.row) {
    klu_defaults(&common_);
    common_.btf = btf == BlockTriangularForm::on;
    common_.scale = -1;  // row scaling costs a tenth and these matrices need none
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
    if (!numeric_ || common_.status != KLU_OK) return false;
    chosen_ = pivot_array().abs();
    return true;
  }

  void solve(double* b) override { solve_all(b, 1); }
  /// Overwrites B (n × right_sides, column by column) with A⁻¹ B.
  void solve_all(double* b, int right_sides) {
    klu_solve(symbolic_, numeric_, n_, right_sides, b, &common_);
  }

  /// Overwrite B (n × right_sides) with D⁻¹ B and D⁻ᵀ B, D being the irreducible blocks of A
  /// without what couples them.
  void solve_blocks(double* b, int right_sides = 1) {
    uncoupled([&] { solve_all(b, right_sides); });
  }
  void solve_blocks_transposed(double* b, int right_sides = 1) {
    uncoupled([&] { solve_transposed(b, right_sides); });
  }

  /// Overwrites B (n × right_sides) with A⁻ᵀ B.
  void solve_transposed(double* b, int right_sides = 1) {
    klu_tsolve(symbolic_, numeric_, n_, right_sides, b, &common_);
  }

  Pivots pivots() const override {
    Pivots result{.reuse_order = true, .choices = pivot_choices_};
    if (numeric_ && chosen_.size() == n_)
      result.shrinkage = (chosen_ / pivot_array().abs()).maxCoeff();
    return result;
  }

  void forget_pivots() override { klu_free_numeric(&numeric_, &common_); }

  /// Returns the column at which factor() found the matrix singular.
  int singular_column() const { return common_.singular_col; }

  /// Return the irreducible blocks. Block b has the rows block_rows()[k], and the columns
  /// block_columns()[k], for k from block_start()[b] to block_start()[b + 1].
  std::span<const int> block_start() const {
    return {symbolic_->R, static_cast<std::size_t>(symbolic_->nblocks) + 1};
  }
  std::span<const int> block_rows() const { return {symbolic_->P, row_count()}; }
  std::span<const int> block_columns() const { return {symbolic_->Q, row_count()}; }
  /// Return the rows of the blocks in pivot order, and the pivots, of the last factors.
  std::span<const int> pivot_rows() const { return {numeric_->Pnum, row_count()}; }
  std::span<const double> pivot_values() const {
    return {static_cast<const double*>(numeric_->Udiag), row_count()};
  }

 private:
  template <class Solve>
  void uncoupled(Solve&& solve_any) {
    uncoupled_.resize(row_count() + 1);
    int* const coupled = std::exchange(numeric_->Offp, uncoupled_.data());
    solve_any();
    numeric_->Offp = coupled;
  }

  std::size_t row_count() const { return static_cast<std::size_t>(n_); }
  Eigen::Map<const Eigen::ArrayXd> pivot_array() const { return {pivot_values().data(), n_}; }

  /// Returns whether the smallest pivot is large enough compared with the largest (klu_rcond). The
  /// bound is SUNDIALS'.
  bool pivots_are_good() const {
    static const double trusted = std::pow(std::numeric_limits<double>::epsilon(), 2.0 / 3.0);
    const auto size = pivot_array().abs();
    return size.minCoeff() > trusted * size.maxCoeff();
  }

  int n_;
  std::vector<int> start_, row_;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  long pivot_choices_ = 0;
  Eigen::ArrayXd chosen_;       // sizes of the pivots when their order was chosen
  std::vector<int> uncoupled_;  // column starts of a matrix without entries between blocks
};

}  // namespace desmo
