#pragma once

namespace desmo {

/// Solver of linear systems with the scaled Jacobian A of one part (JacobianFactors scales rows and
/// columns of Φ_φ). Its sparsity pattern never changes: the constructor takes the Pattern, analyses
/// it and allocates; later calls allocate nothing of ours. Real is double or float.
template <class Real>
class LinearSolver {
 public:
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  /// Factorises A. values: (entries of the pattern), read until the last solve() with these
  /// factors. Returns false when a pivot is zero; of a nearly singular matrix the factors are
  /// returned.
  virtual bool factor(const Real* values) = 0;

  /// Overwrites b (n) with A⁻¹ b, using the last factors.
  virtual void solve(Real* b) = 0;

  /// Returns the number of solve() calls, with a residual each, that cost as much as a new Jacobian
  /// and its factors. The default is that of sparse factorisations, where the Jacobian is a good
  /// part of the cost.
  virtual int break_even_solves() const { return 3; }

  /// Returns whether the factors have fewer digits than Real.
  virtual bool rounds_factors() const { return false; }

  /// Returns whether factor() may reuse the pivot order of an earlier call.
  virtual bool reuses_pivots() const { return false; }

  /// Returns the largest factor by which a pivot has shrunk since the order was chosen. Rounding
  /// errors grow by the same factor.
  virtual double pivot_shrinkage() const { return 1; }

  /// Makes the next factor() choose its pivots anew.
  virtual void forget_pivots() {}

  /// Returns how often factor() chose a pivot order, where it may reuse one.
  virtual long pivot_choices() const { return 0; }
};

}  // namespace desmo
