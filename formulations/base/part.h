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

/// What became of one part in one step.
struct PartResult {
  Status status = Status::converged;
  int iterations = 0;
  double residual2 = 0;  ///< ‖Φ‖₂² of the part's equations, each over its magnitude, at the end
};

/// Parts of one formulation, one behind the other, of which many are solved in one call as long as
/// each finds its solution at once.
class PartRun {
 public:
  struct Result {
    int solved = 0;      ///< how many, up to the first that has to be solved by itself
    int iterations = 0;  ///< the most of any of them …
    long all = 0;        ///< … and of all together
    double residual2 = 0;
  };

  virtual ~PartRun() = default;
  virtual int size() const = 0;
  /// Solves members from `first` on, each as its own solve() would.
  virtual Result solve(State& state, int first, Level level) = 0;
  /// What members keep from earlier steps no longer holds: it was said to each of them, too.
  virtual void forget() = 0;
};

class Keeper;

/// Solves its unknowns, given those of all earlier parts. Owns its workspace; never touches the
/// heap after its construction, apart from what a library does inside.
class Part {
 public:
  virtual ~Part() = default;

  /// Solves position, velocity and acceleration of the part's unknowns, up to `level`. Overwrites
  /// these in `state`; on failure they are unspecified. The initial guess is the positions in
  /// state.q of those that starts_from() names, and there are the last ones of those that
  /// stays_near() names; those of the others are not read. last: positions as in state.q, of the
  /// instant before or of an estimate, for who has to start anew.
  virtual PartResult solve(State& state, std::span<const double> last, Level level) = 0;

  /// Those of its unknowns, ascending, of which solve() reads the position in the state: what a
  /// guess is needed for.
  virtual std::vector<int> starts_from(const std::vector<int>& unknowns) const { return unknowns; }

  /// Others of its unknowns, ascending: angles in closed form, which lie within half a turn of the
  /// last ones.
  virtual std::vector<int> stays_near() const { return {}; }

  /// Of its unknowns only these are read by others between one instant and the next; of the rest
  /// solve() may leave velocities and accelerations in the state as they were, and positions where
  /// a keeper has predicted them. read: of each coordinate. Until then all are.
  virtual void write_only(const std::vector<bool>& read) { static_cast<void>(read); }

  /// This part where it keeps what it finds (see keeper.h), or null.
  virtual Keeper* keeper() { return nullptr; }

  /// A run of as many of these, which begin with this one, as can be solved in one call; null where
  /// that is not worth while.
  virtual std::unique_ptr<PartRun> make_run(std::span<Part* const> parts) {
    static_cast<void>(parts);
    return nullptr;
  }

  /// How often an order of pivots that is meant to last, of the factorisation before or of
  /// generated code, had gone bad, and pivots were chosen anew.
  virtual long refactorisations() const { return 0; }

  /// Returns whether its rates may come from an order of pivots that was chosen at another
  /// position.
  virtual bool reuses_pivots() const { return false; }

  /// Voids what earlier steps left behind: the next solve() starts from an estimate.
  virtual void forget() {}
  /// Says that the assembly is over, which began with forget(): what follows are steps.
  virtual void end_assembly() {}
};

}  // namespace desmo
