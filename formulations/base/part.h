#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/part_chain.h"
#include "formulations/base/settings.h"
#include "formulations/base/state.h"
#include "formulations/base/summary.h"

namespace desmo {

class ResidentPart;  // base/resident_part.h

/// Settings of one part: those of the analysis that its solver reads, and its own tolerance.
struct PartSettings {
  explicit PartSettings(const Settings& s)
      : tolerance(s.tolerance),
        max_iterations(s.max_iterations),
        fixed_iterations(s.fixed_iterations),
        jacobian(s.jacobian),
        factorisation(s.factorisation) {}

  double tolerance;  ///< limit of ‖Φ‖₂ of the part's own equations, each over its magnitude
  int max_iterations, fixed_iterations;  ///< see Settings
  JacobianUpdate jacobian;
  Factorisation factorisation;
  /// True where the requested tolerance is below the part's rounding floor, which replaces it.
  /// Newton's method then makes one more correction once it has met the tolerance. Explicit
  /// parts need none: their cores are iterated to a fraction of the tolerance.
  bool at_rounding = false;
};

/// The outcome of one part in one step.
struct PartResult {
  Status status = Status::solved;
  int iterations = 0;  ///< of Newton's method, its failed attempts included
  double residual2 = 0;  ///< ‖Φ‖₂² of the part's equations, each over its magnitude, at the end
};

/// Coordinates that a part reads.
struct PartInputs {
  /// Unknowns of its own, ascending, whose predicted position solve() starts from.
  std::vector<int> predicted;
  /// Other unknowns of its own, ascending: angles in closed form, unwrapped to within half a turn
  /// of their last values.
  std::vector<int> unwrapped;
  std::vector<int> others;  ///< coordinates, not its own, that it reads in the state
  /// Driven coordinates that it takes from the driver row, in the order of the row, as often as
  /// they stand there. Where no step was begun, solve() reads them in the state.
  std::vector<int> drivers;
};

/// A solver of some unknowns, given those of all earlier parts. It owns its workspace. After its
/// construction it takes nothing from the heap; a library inside may.
class Part {
 public:
  virtual ~Part() = default;

  /// Solves position, velocity and acceleration of the part's unknowns, up to `level`.
  /// - state: its unknowns are overwritten; on failure they are unspecified. On entry state.q has
  ///   those unknowns that inputs() names, predicted or as at the instant before.
  /// - last: positions of the instant before, or of an estimate, laid out like state.q. A part may
  ///   start anew from these where it finds no solution from the prediction.
  virtual PartResult solve(State& state, std::span<const double> last, Level level) = 0;

  /// Returns the coordinates that solve() reads. equations: the coordinates that Newton's method
  /// reads: all unknowns of the part, as predicted ones, and all others in its equations.
  virtual PartInputs inputs(PartInputs equations) const { return equations; }

  /// Returns the part as one that keeps what it finds; null: it leaves all in the state.
  virtual ResidentPart* resident() { return nullptr; }

  /// Makes a chain of the first of `parts`: this one and as many more as can be solved in one call.
  /// Returns null where a chain would save nothing.
  virtual std::unique_ptr<PartChain> make_chain(std::span<Part* const> parts) {
    static_cast<void>(parts);
    return nullptr;
  }

  /// Returns how often a pivot order that is meant to last had gone bad, and pivots were chosen
  /// anew:
  /// - linear solvers that reuse pivots: new choices of the order after the first
  /// - generated code: steps left to the pivoting part (GuardedPart::fallbacks)
  virtual long refactorisations() const { return 0; }

  /// Returns whether rates may come from an order of pivots that was chosen at another position.
  virtual bool reuses_pivots() const { return false; }

  /// Voids what earlier steps left behind: the next solve() starts from an estimate.
  virtual void forget() {}
  /// Tells that the assembly is over, which began with forget(): what follows are steps.
  virtual void end_assembly() {}
};

/// Second interface of a part whose linear solver may reuse a pivot order (Part::reuses_pivots).
class PivotReuse {
 public:
  virtual ~PivotReuse() = default;
  /// Returns the largest factor by which a pivot has shrunk since the order was chosen. Rounding
  /// errors grow by the same factor.
  virtual double pivot_shrinkage() const = 0;
};

}  // namespace desmo
