#pragma once

#include "cases/mechanism/level.h"
#include "formulations/base/state.h"

namespace desmo {

/// Parts of one formulation that follow each other, of which many are solved in one call as long as
/// each finds its solution at once.
class PartChain {
 public:
  struct Result {
    int solved = 0;      ///< members, up to the first that has to be solved by itself
    int iterations = 0;  ///< the most of any of them …
    long all = 0;        ///< … and of all together
    double residual2 = 0;
  };

  virtual ~PartChain() = default;
  virtual int size() const = 0;
  /// Solves members from `first` on, each as its own solve() would.
  virtual Result solve(State& state, int first, Level level) = 0;
  /// Voids what members keep from earlier steps; each of them is told, too.
  virtual void forget() = 0;
};

}  // namespace desmo
