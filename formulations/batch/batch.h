#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "formulations/base/output.h"
#include "formulations/base/resident_part.h"
#include "formulations/batch/kernel_batch.h"
#include "formulations/batch/layout.h"
#include "formulations/motion/prediction/guess.h"
#include "formulations/motion/prediction/motions_ahead.h"

namespace desmo {

/// The parts of a subsystem of a mechanism (an axle), in the order of solution.
using Subsystem = std::vector<std::unique_ptr<ExplicitPart>>;
/// The kernels of a subsystem's parts, in their order, all for the same number of lanes.
using SubsystemKernels = std::vector<const LaneKernel*>;

/// The origin of a number in the state: it never moves, a driver gives it, a part finds it.
enum class StateKind : char { constant, driven, solved };

// clang-format off
//
// Who holds what, and in which layout (two parts a subsystem, 4 lanes):
//
//   State, outputs                             BatchState: now and before        parts_
//   one subsystem after the other              side by side in lanes
//   ┌────────────┬────────────┬──         number 0 │ l0 │ l1 │ l2 │ l3 │
//   │ subsystem 0│ subsystem 1│  Gather →  number 1 │ l0 │ l1 │ l2 │ l3 │  ⇄  KernelBatch of first parts
//   └────────────┴────────────┴── ← Scatter number 2 │ l0 │ l1 │ l2 │ l3 │  ⇄  KernelBatch of second parts
//   q[places_[l][n]]                      q[n · lanes + l]
//
// A *number* n is one that the first subsystem reads or writes. A KernelBatch holds dimensions,
// weights and branches of its parts in lanes. The parts themselves solve a subsystem alone.
//
// clang-format on

/// A batch of equal subsystems, one in each lane, solved by one call of each kernel. Their state
/// stays in lanes from one instant to the next. Where subsystems are fewer than lanes, the first
/// fills the rest.
class Batch {
 public:
  /// The outcome of a step.
  struct Step {
    unsigned accepted = 0;  ///< bit l: every part of subsystem l is accepted
    int iterations = 0;     ///< largest of a part, up to the one that refused a lane
    /// ‖Φ‖₂² of each subsystem; unspecified where not accepted
    std::array<double, max_lanes> residual2{};
  };

  /// subsystems: alike, as are_alike() says; they outlive the batch. kinds: the origin of each
  /// position in the state.
  Batch(std::span<Subsystem> subsystems, const SubsystemKernels& kernels,
        const std::vector<StateKind>& kinds, Guess guess);

  std::span<Subsystem> subsystems() const { return subsystems_; }
  /// Returns what Step::accepted is when every subsystem is accepted.
  unsigned all() const { return (1u << subsystems_.size()) - 1; }

  /// Returns the driven coordinates that the batch takes from the row, in its order: see
  /// PartInputs::drivers.
  std::vector<int> drivers() const;
  /// Returns all other positions in the state that the parts read, repeats included.
  std::vector<int> inputs() const;
  /// See ResidentPart.
  void bind(const PartOutputs& outputs);
  void begin_step(const StepHistory& history, const MotionRow& row);
  /// Returns how many numbers of the row are its drivers.
  std::size_t in_row() const { return driven_.size() * lanes_; }
  /// Returns whether the step starts from a prediction by kept instants. Otherwise it starts from
  /// the positions in the state.
  bool predicted() const { return predicted_; }
  /// Forgets all instants. solve() accepts no subsystem until copy_from() finds a position of every
  /// part.
  void forget() { assembled_ = kept_ = predicted_ = is_driven_ = false; }

  /// Solves positions, velocities and accelerations of all subsystems. Accepts none where a part
  /// has no branch yet (see assembled_). Results that are not accepted are unspecified.
  const Step& solve(const State& state);
  /// Copies constants, drivers and unknowns of all subsystems from the state; takes their branches.
  void copy_from(const State& state);

  /// See ResidentPart.
  void deliver(const OutputView& output, Level level) const;

  /// Writes the observed unknowns and their rates to the state, up to `level`. Unless the step was
  /// predicted(), writes the positions of all unknowns and drivers, observed or not.
  void write_observed(State& state, Level level) const;
  /// Writes the solution of one subsystem to the state: its unknowns and drivers.
  void store(std::size_t subsystem, State& state) const { store(own_, subsystem, state); }
  /// Writes the drivers of one subsystem, which it reads in the state when it is solved alone.
  void store_drivers(std::size_t subsystem, State& state) const {
    store(driven_, subsystem, state);
  }
  /// Writes the positions that a subsystem had at the instant before.
  void restore(std::size_t subsystem, std::span<double> q) const;

 private:
  /// Uses of a number by the parts.
  struct Use {
    bool is_read = false;  // before any part has written it
    bool is_unknown = false, is_unwrapped = false;
  };

  /// Returns the subsystem in a lane: the first one in lanes that are left over.
  Subsystem& subsystem_in(std::size_t lane) const {
    return subsystems_[lane < subsystems_.size() ? lane : 0];
  }
  std::vector<Use> add_parts(const SubsystemKernels& kernels,
                             std::span<const ExplicitPart* const> first,
                             std::span<const int> of_first);
  Scatter targets(std::span<const int> numbers, std::span<int> places) const;
  template <std::size_t lanes>
  void write_drivers(MotionRow row);
  void store(std::span<const int> numbers, std::size_t subsystem, State& state) const;
  void scatter(const Scatter& targets, Level level, const OutputView& to) const;
  template <class Visit>
  void for_numbers(std::span<const int> numbers, std::size_t lane, Visit&& visit) const;

  std::span<Subsystem> subsystems_;
  std::vector<KernelBatch> parts_;
  std::size_t lanes_;
  LanePlaces places_;                   // the place in the state of each number of each lane
  std::vector<int> unknowns_, driven_;  // unknowns, drivers: numbers, ascending
  std::vector<int> own_;                // both unknowns and drivers, ascending
  // numbers that no part of the batch finds: constant ones, read by copy_from(); others, read in
  // every step
  Gather constants_, moving_;
  Gather undriven_;               // driven numbers, read in the state where no step was begun
  Gather starts_;                 // unknowns, read in the state where none are predicted
  Scatter observed_, delivered_;  // numbers to write to the state, and to lent outputs
  BatchState state_;
  LaneValues residuals2_;  // ‖Φ‖₂² of each lane, max_lanes values for each part
  Step step_;
  bool assembled_ = false;  // every part has found a position since forget()
  bool kept_ = false;       // state_ has an instant solved since forget()
  bool predicted_ = false;  // the step starts from a prediction
  bool is_driven_ = false;  // begin_step() has written the step's drivers to state_
};

/// Returns whether two subsystems can be solved in lanes of one batch. Two conditions must hold:
/// - Their parts have the same types in the same order.
/// - Two numbers that the parts of `a` read or write are one coordinate exactly if those of `b`
/// are.
bool are_alike(std::span<const ExplicitPart* const> a, std::span<const ExplicitPart* const> b);

}  // namespace desmo
