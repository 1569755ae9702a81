#pragma once

namespace desmo {

/// Solves linear systems with the matrix Φ_φ of one part, whose sparsity pattern never changes. An
/// implementation takes the Pattern at construction, analyses it and allocates; afterwards nothing
/// of ours is allocated. Real is double or float. NewtonSolver calls it once for each
/// factorisation and once for each right-hand side.
template <class Real>
class LinearSolver {
 public:
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  /// Factorises Φ_φ. values: (entries of the pattern), read until the last solve() with these
  /// factors. Returns false when the matrix is singular.
  virtual bool factor(const Real* values) = 0;

  /// b (n) = Φ_φ⁻¹ b with the last factors.
  virtual void solve(Real* b) = 0;

  /// Returns how many calls of solve(), with a residual each, cost about as much as a new Jacobian
  /// and its factors.
  virtual int break_even_solves() const = 0;

  /// Returns whether the factors have fewer digits than Real.
  virtual bool rounds_factors() const { return false; }

  /// Returns whether factor() may reuse the order of pivots of an earlier call.
  virtual bool reuses_pivots() const { return false; }

  /// Makes the next factor() choose its pivots anew.
  virtual void forget_pivots() {}

  /// Returns how often factor() chose the order of pivots, where it may reuse one.
  virtual long pivot_choices() const { return 0; }
};

/// LinearSolver::break_even_solves of sparse factorisations, of which assembly is a good part.
inline constexpr int sparse_break_even_solves = 3;

}  // namespace desmo
