#pragma once

#include "cases/mechanism/level.h"
#include "formulations/base/state.h"

namespace desmo {

/// A chain of parts, its members, that follow each other in a formulation. One call solves many of
/// them. It ends at a member that it cannot solve, for which Part::solve() is to be called.
class PartChain {
 public:
  struct Result {
    int solved = 0;             ///< number of members solved, one after the other from `first` on
    int iterations = 0;         ///< largest number of iterations of a solved member
    long total_iterations = 0;  ///< sum over the solved members
    double residual2 = 0;       ///< ‖Φ‖₂² of the solved members together
  };

  virtual ~PartChain() = default;
  /// Returns the number of members.
  virtual int size() const = 0;
  /// Solves members from `first` on up to `level`, each as its Part::solve() would from the
  /// prediction. Overwrites their unknowns in the state. Unknowns of the first member that is not
  /// solved are unspecified.
  virtual Result solve(State& state, int first, Level level) = 0;
  /// Discards what the chain keeps for its members from earlier steps. The caller also calls
  /// Part::forget() of each member.
  virtual void forget() = 0;
};

}  // namespace desmo
