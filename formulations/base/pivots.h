#pragma once

namespace desmo {

/// The state of a linear solver's pivots.
struct Pivots {
  /// True where factors may use a pivot order that was chosen at another position.
  bool reuse_order = false;
  long choices = 0;  ///< how often an order was chosen, where one may be reused
};

}  // namespace desmo
