#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/part_chain.h"
#include "formulations/base/settings.h"
#include "formulations/base/state.h"
#include "formulations/base/summary.h"

namespace desmo {

class ResidentPart;  // defined in base/resident_part.h

/// Settings of one part: the analysis' settings that the part's solver reads, and the part's own
/// limits. All limits are on ‖Φ‖₂ of the part's equations, each divided by its magnitude.
struct PartSettings {
  /// - s: settings of the analysis, with the part's share of the tolerance
  /// - rounding: the part's rounding floor (Magnitudes::rounding), which replaces a tolerance below
  ///   it
  explicit PartSettings(const Settings& s, double rounding = 0)
      : tolerance(std::max(s.tolerance, rounding)),
        max_iterations(s.max_iterations),
        jacobian(s.jacobian),
        at_rounding(tolerance > s.tolerance) {
    if (s.fixed_iterations == 0) return;
    stop = 0;
    accept = std::numeric_limits<double>::infinity();
    max_iterations = s.fixed_iterations;
  }

  double tolerance;           ///< the part's share or, if larger, its rounding floor
  double stop = tolerance;    ///< limit below which iterations end; 0: their number is fixed
  double accept = tolerance;  ///< limit below which a position is a solution; infinite if stop is 0
  int max_iterations;         ///< maximum number of iterations of Newton's method in one attempt
  JacobianUpdate jacobian;
  /// True where the rounding floor replaced the tolerance. Newton's method then makes one more
  /// correction after it has met the limit, if an iteration is left. Explicit parts make none:
  /// their cores are iterated to a fraction of the tolerance.
  bool at_rounding;
};

/// The outcome of one part in one step.
struct PartResult {
  Status status = Status::solved;
  /// Iterations of Newton's method, its failed attempts included. Iterations that generated code
  /// made before it refused the step may be missing.
  int iterations = 0;
  double residual2 = 0;  ///< ‖Φ‖₂² at the end, each equation divided by its magnitude
};

/// Counts of what a part met since its construction. InlinedPart leaves out completed assemblies,
/// which may start far from a solution.
struct PartCounts {
  /// Number of times a pivot order that is meant to last was chosen anew:
  /// - linear solvers that reuse pivots: new choices of the order after the first
  /// - generated code: its fallbacks
  long refactorisations = 0;
  /// Number of steps that generated code left to a pivoting part. Either a pivot, a divisor or a
  /// square root was too small, or the equations were not satisfied.
  long fallbacks = 0;
  /// Number of fallbacks that ended on another branch than the step before. Only ExplicitPart can
  /// tell; others leave it 0.
  long branch_changes = 0;

  PartCounts& operator+=(const PartCounts& other) {
    refactorisations += other.refactorisations;
    fallbacks += other.fallbacks;
    branch_changes += other.branch_changes;
    return *this;
  }
};

/// The numbers that Part::solve() reads, as indices in the state.
struct PartInputs {
  /// The part's unknowns from whose predicted positions solve() starts, ascending.
  std::vector<int> predicted;
  /// The part's unknowns that are angles in closed form, ascending. solve() reads their last values
  /// and unwraps the angles to within half a turn of these.
  std::vector<int> unwrapped;
  std::vector<int> others;  ///< all other numbers of the state that solve() may read
  /// Driven coordinates that the part takes from the driver row (ResidentPart::begin_step): entry k
  /// of the row is coordinate drivers[k]. A coordinate that several lanes read is there several
  /// times. Where no step was begun, solve() reads these coordinates in the state.
  std::vector<int> drivers;
};

/// A solver of some unknowns, given those of all earlier parts. It owns its workspace. After its
/// construction it takes nothing from the heap; a library inside may.
class Part {
 public:
  virtual ~Part() = default;

  /// Solves position, velocity and acceleration of the part's unknowns, up to `level`.
  /// - state: the part's unknowns are overwritten; on failure they are unspecified. On entry
  ///   state.q holds the unknowns that inputs() names: as predicted, or as at the instant before.
  /// - last: positions of the instant before, or of an estimate, laid out like state.q. Where a
  ///   part finds no solution from the prediction, it may start anew from these.
  virtual PartResult solve(State& state, std::span<const double> last, Level level) = 0;

  /// Returns what solve() reads. equations: what Newton's method would read. That is all unknowns
  /// of the part, as `predicted`, and all other variables of its equations, as `others`.
  virtual PartInputs inputs(PartInputs equations) const { return equations; }

  /// Returns this part as a ResidentPart; null: all its results are in the state.
  virtual ResidentPart* resident() { return nullptr; }

  /// Makes a chain of the first of `parts`: this part, which is the first, and as many after it as
  /// one call can solve. Returns null where a chain would save nothing.
  virtual std::unique_ptr<PartChain> make_chain(std::span<Part* const> parts) {
    static_cast<void>(parts);
    return nullptr;
  }

  /// Returns what the part counted in all its steps.
  virtual PartCounts counts() const { return {}; }

  /// Discards what earlier steps left in the part. Each solve() until end_assembly() is part of an
  /// assembly.
  virtual void forget() {}
  /// Tells that the assembly that began with forget() is over: each later solve() is a step.
  virtual void end_assembly() {}
};

}  // namespace desmo
