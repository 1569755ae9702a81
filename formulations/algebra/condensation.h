#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "formulations/algebra/linear_solver.h"
#include "formulations/equations/pattern.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Static condensation: a solver that eliminates derived unknowns before another solver, of the
/// rest alone, sees the system. Rows d are derivations and columns y what they derive, rows c are
/// closures and columns x the rest. D_y is triangular:
///
///   A = [D_x D_y; C_x C_y]      A_r = C_x − C_y D_y⁻¹ D_x      b_r = b_c − C_y D_y⁻¹ b_d
///   x = A_r⁻¹ b_r               y = D_y⁻¹ (b_d − D_x x)
///
/// A_r of a Jacobian A is what textbooks have by the chain rule. In reference-point coordinates it
/// is ∂Φ/∂(r, e), with position r and Euler parameters e of each body. In relative ones it is Φ_q B
/// with the velocity transformation B from joint rates to q̇ (Kim and Vanderploeg 1986).
class Condensed final : public LinearSolver {
 public:
  using MakeSolver = std::function<std::unique_ptr<LinearSolver>(const Pattern&)>;

  /// - pattern: that of A
  /// - derivations: those of the part (see derivations()); in their order D_y is triangular
  /// - make_solver: makes the solver of A_r from its pattern; not called where all is derived
  Condensed(const Pattern& pattern, std::span<const Derivation> derivations,
            const MakeSolver& make_solver);

  bool factor(const double* values) override;
  void solve(double* b) override;
  void solve_closures(double* b) override;

  int break_even_solves() const override;
  Pivots pivots() const override;
  void forget_pivots() override;

  /// Returns the pattern of A_r. Its unknowns are those of the part that are not derived.
  const Pattern& reduced_pattern() const { return reduced_; }
  /// Returns the number of multiply-adds by which factor() condenses.
  int operations() const { return static_cast<int>(operations_.size()); }

 private:
  struct Copy {
    int to, from;  // positions in work_ and in the values of A
  };
  struct Operation {
    int target, factor, source;  // positions in work_: target += factor · source
  };
  struct DerivedTerm {
    int closure, derived, factor;  // row of A_r, position in derived_, position in work_
  };
  struct DerivedUnknown {
    int row, column, pivot;  // row and column of A, position of the pivot among its values
    int first, end;          // range of its terms
  };
  struct Term {
    int column, from;  // column of A, position among its values
  };

  Pattern reduced_;
  std::unique_ptr<LinearSolver> solver_;  // solver of A_r; null: all is derived
  std::vector<DerivedUnknown> derived_;   // derived unknowns, in the order of derivations
  std::vector<Term> terms_;   // entries of derivations except pivots, ordered by derivation
  std::vector<Copy> copies_;  // entries of closures
  std::vector<Operation> operations_;  // ordered by derivation, the last first, then by closure
  std::vector<DerivedTerm> derived_terms_;  // C_y, with what elimination adds to it
  std::vector<int> closure_row_, column_;   // row, column of A for each one of A_r
  int cleared_ = 0;  // number of values in work_ that are sums: A_r, then C_y
  // A_r; C_y; then the terms, each divided by −pivot of its row
  std::vector<double> work_;
  std::vector<double> scale_;  // −1/pivot of each derivation
  std::vector<double> x_, y_;  // right-hand side, then solution
};

}  // namespace desmo
