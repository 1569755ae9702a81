#pragma once

namespace desmo {

/// The state of a linear solver's pivots.
struct Pivots {
  /// True where factors may use a pivot order that was chosen at another position.
  bool reuse_order = false;
  long choices = 0;  ///< number of times an order was chosen; counted where one may be reused
};

/// Solver of linear systems with the scaled Jacobian A of one part (JacobianFactors scales rows and
/// columns of Φ_φ). Its sparsity pattern never changes. The constructor takes the Pattern, analyses
/// it and allocates. Later calls take no memory from the heap unless the library needs it.
class LinearSolver {
 public:
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  /// Factorises A. values: (entries of the pattern), by columns as Pattern has them, read until the
  /// last solve() with these factors. Returns false when A is singular by the library's own limit,
  /// which is zero for some. No solve() follows then until another factor() succeeds.
  virtual bool factor(const double* values) = 0;

  /// Overwrites b (n) with A⁻¹ b, using the last factors.
  virtual void solve(double* b) = 0;

  /// Returns the number of solve() calls, with a residual each, that cost as much as a new Jacobian
  /// and its factors. The default is that of sparse factorisations, where the Jacobian is a good
  /// part of the cost.
  virtual int break_even_solves() const { return 3; }

  /// Returns the state of the pivots. The default is that of a solver that chooses them anew in
  /// every factor().
  virtual Pivots pivots() const { return {}; }

  /// Makes the next factor() choose its pivots anew.
  virtual void forget_pivots() {}

  /// Like solve(), for b with 0 in the rows of derivations. A solver that condenses writes 0 to
  /// derived unknowns.
  virtual void solve_closures(double* b) { solve(b); }
};

}  // namespace desmo
