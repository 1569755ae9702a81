#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/settings.h"
#include "formulations/base/summary.h"

namespace desmo {

/// The state (q, then the components of the fixed entities) and its time derivatives; those of
/// the fixed entities are zero. All three have Model::state_size() components.
struct State {
  std::vector<double> q, qd, qdd;
};

/// Settings of one part.
struct PartSettings {
  PartSettings(const Settings& settings) : analysis(settings), tolerance(settings.tolerance) {}

  Settings analysis;  ///< in which the tolerance is not the part's
  double tolerance;   ///< limit of ‖Φ‖₂ of the part's own equations, each over its magnitude
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

/// Places where the results of the parts go in a run.
struct PartOutputs {
  /// For each position in the state, whether it is read there by other parts, by the prediction, or
  /// by an observer that lends no memory.
  const std::vector<bool>& observed;
  /// For each position in the state its place in the outputs that an observer lends, or −1. A part
  /// sets to −1 what it delivers itself. Empty: none are lent.
  std::span<int> places;
  Level level;  ///< the highest at which anyone asks for the part's unknowns
};

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

struct MotionRow;
struct OutputView;
struct StepHistory;

/// The further duties of a part, such as a batch, that keeps what it finds in a layout of its own
/// from one instant to the next. It predicts from there, and writes to the state only what is
/// observed there.
class ResidentPart {
 public:
  virtual ~ResidentPart() = default;

  /// Fixes, before a run, where results go. Until then all are written to the state.
  virtual void bind(const PartOutputs& outputs) = 0;
  /// Begins a step. history: of the instants solved, the last of which the part keeps; where it is
  /// unknown, as after a failure, solve() starts from the positions in the state, which are then
  /// complete, and leaves all of them there. row: begins with PartInputs::drivers at the instant to
  /// come.
  virtual void begin_step(const StepHistory& history, const MotionRow& row) = 0;
  /// Writes the instant solved last to an output, up to `level`, as bound.
  virtual void deliver(const OutputView& output, Level level) const = 0;
  /// Writes the instant solved last to the state: unknowns, and drivers taken from the row.
  virtual void store(State& state) const = 0;
  /// Writes positions of the instant before the one solved last, or tried; nothing where that one
  /// was not predicted from it.
  virtual void restore(std::span<double> q) const = 0;
};

/// Solves its unknowns, given those of all earlier parts. Owns its workspace; never touches the
/// heap after its construction, apart from what a library does inside.
class Part {
 public:
  virtual ~Part() = default;

  /// Solves position, velocity and acceleration of the part's unknowns, up to `level`. Overwrites
  /// these in `state`; on failure they are unspecified. Of its unknowns it reads in state.q what
  /// inputs() names, as predicted or last. last: positions as in state.q, of the instant before or
  /// of an estimate, from which a part starts that has to start anew.
  virtual PartResult solve(State& state, std::span<const double> last, Level level) = 0;

  /// Returns what solve() reads. equations: all unknowns, as predicted, and what the equations read
  /// of others.
  virtual PartInputs inputs(PartInputs equations) const { return equations; }

  /// Returns the part as one that keeps what it finds; null: it leaves all in the state.
  virtual ResidentPart* resident() { return nullptr; }

  /// Makes a chain of the first of `parts`, this one and as many as can be solved in one call; null
  /// where that is not worth while.
  virtual std::unique_ptr<PartChain> make_chain(std::span<Part* const> parts) {
    static_cast<void>(parts);
    return nullptr;
  }

  /// Returns how often an order of pivots that is meant to last, of the factorisation before or of
  /// generated code, had gone bad, and pivots were chosen anew.
  virtual long refactorisations() const { return 0; }

  /// Returns whether its rates may come from an order of pivots that was chosen at another
  /// position, or from normal equations.
  virtual bool reuses_pivots() const { return false; }

  /// Voids what earlier steps left behind: the next solve() starts from an estimate.
  virtual void forget() {}
  /// Tells that the assembly is over, which began with forget(): what follows are steps.
  virtual void end_assembly() {}
};

}  // namespace desmo
