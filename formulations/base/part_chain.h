#pragma once

#include "cases/mechanism/level.h"
#include "formulations/base/state.h"

namespace desmo {

/// A chain of parts that follow each other in a formulation. One call solves many of them, as long
/// as each finds its solution at once.
class PartChain {
 public:
  struct Result {
    int solved = 0;  ///< number of members solved, before the first that has to be solved by itself
    int iterations = 0;         ///< largest number of iterations of a member
    long total_iterations = 0;  ///< sum over the solved members
    double residual2 = 0;       ///< ‖Φ‖₂² of the solved members together
  };

  virtual ~PartChain() = default;
  virtual int size() const = 0;
  /// Solves members from `first` on, each as its own solve() would.
  virtual Result solve(State& state, int first, Level level) = 0;
  /// Voids what the chain keeps for its members from earlier steps. Part::forget() is called for
  /// each member as well.
  virtual void forget() = 0;
};

}  // namespace desmo
