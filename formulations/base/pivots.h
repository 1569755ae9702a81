#pragma once

namespace desmo {

/// The state of a linear solver's pivots, and what they do to rates.
struct Pivots {
  /// True where factors may use a pivot order that was chosen at another position.
  bool reuse_order = false;
  /// True for normal equations: their errors grow with the square of the condition number.
  bool square_condition = false;
  /// The largest factor by which a pivot has shrunk since the order was chosen. Rounding errors
  /// grow by the same factor.
  double shrinkage = 1;
  long choices = 0;  ///< how often an order was chosen, where one may be reused

  /// Returns whether rates may be worse than the condition number explains.
  bool may_spoil_rates() const { return reuse_order || square_condition; }
};

}  // namespace desmo
