#pragma once

#include "cases/mechanism/level.h"
#include "formulations/base/state.h"

namespace desmo {

/// A chain of parts that follow each other in a formulation. One call solves many of them. It ends
/// at a part that it cannot solve, for which Part::solve() is to be called.
class PartChain {
 public:
  struct Result {
    int solved = 0;             ///< number of parts solved, one after the other from `first` on
    int iterations = 0;         ///< largest number of iterations of a solved part
    long total_iterations = 0;  ///< sum over the solved parts
    double residual2 = 0;       ///< ‖Φ‖₂² of the solved parts together
  };

  virtual ~PartChain() = default;
  /// Returns the number of parts.
  virtual int size() const = 0;
  /// Solves parts from `first` on up to `level`, each as its Part::solve() would from the
  /// prediction. Overwrites their unknowns in the state. Unknowns of the first part that is not
  /// solved are unspecified.
  virtual Result solve(State& state, int first, Level level) = 0;
  /// Discards what the chain keeps for its parts from earlier steps. The caller also calls
  /// Part::forget() of each part.
  virtual void forget() = 0;
};

}  // namespace desmo
