#pragma once

#include "cases/mechanism/level.h"
#include "formulations/base/state.h"

namespace desmo {

/// A chain of parts that follow each other in a formulation. One call solves many of them, as long
/// as each finds its solution at once.
class PartChain {
 public:
  struct Result {
    int solved = 0;      ///< members, up to the first that has to be solved by itself
    int iterations = 0;  ///< the most of any of them …
    long all = 0;        ///< iterations of all parts together
    double residual2 = 0;
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
