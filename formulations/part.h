#pragma once

#include <vector>

#include "cases/level.h"

namespace desmo {

/// Where Newton–Raphson starts in a step (see formulations/guess.h).
enum class Guess {
  previous,   ///< q of the last instant
  quadratic,  ///< q + q̇ h + q̈ h²/2 of the last instant, h later
};

/// What an analysis may use. The defaults are the paper's.
struct Settings {
  double tolerance = 1e-10;  ///< on ‖Φ‖₂ of the whole mechanism, in its units
  int max_iterations = 25;   ///< of Newton–Raphson, a step
  Guess guess = Guess::previous;
  /// 0: iterate until the tolerance is met. Otherwise exactly so many iterations a step, whatever
  /// ‖Φ‖₂ is, so that a step's work does not depend on rounding: for counting instructions.
  int fixed_iterations = 0;
};

/// The state (q, then the components of the fixed entities) and its time derivatives; those of
/// the fixed entities are zero. All three have Mechanism::state_size() components.
struct State {
  std::vector<double> q, qd, qdd;
};

enum class Status {
  converged,
  not_converged,  ///< the tolerance was not met in the iterations allowed
  singular,       ///< Φ_φ could not be factorised
  not_finite,     ///< Φ is not a finite number
};

/// What became of one part in one step.
struct PartResult {
  Status status = Status::converged;
  int iterations = 0;
  double residual = 0;  ///< ‖Φ‖₂ of the part's equations where it stopped
};

/// Solves its unknowns, given those of all earlier parts. Owns its workspace; never touches the
/// heap after its construction, apart from what a library does inside.
class Part {
 public:
  virtual ~Part() = default;

  /// Solves position (from the values in state.q, which are the initial guess), velocity and
  /// acceleration of the part's unknowns, up to `level`. Overwrites these in `state`; on failure
  /// they are unspecified.
  virtual PartResult solve(State& state, Level level) = 0;
};

}  // namespace desmo
