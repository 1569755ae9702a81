#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "formulations/base/lane_values.h"
#include "formulations/base/output.h"
#include "formulations/batch/lane_stage.h"
#include "formulations/batch/lane_transport.h"
#include "formulations/prediction/guess.h"
#include "formulations/prediction/motions_ahead.h"
#include "formulations/prediction/predictor.h"

namespace desmo {

/// The parts of a copy of a piece of a mechanism, in the order of solution.
using Copy = std::vector<std::unique_ptr<ExplicitPart>>;
/// For each part of a copy the kernel of its type, all of as many lanes.
using CopyKernels = std::vector<const LaneKernel*>;

/// What becomes of a number in the state: it never moves, a driver gives it, a part finds it.
enum class StateKind : char { constant, driven, solved };

/// Copies of one call of each kernel, and what was found of them, which stays in lanes from one
/// instant to the next. Where copies are fewer than lanes, the first fills the rest.
class LaneBatch {
 public:
  /// What became of a step.
  struct Step {
    unsigned accepted = 0;                      ///< bit by bit, copies of which every part is
    int iterations = 0;                         ///< the most of any part
    std::array<double, max_lanes> residual2{};  ///< ‖Φ‖₂² of each; of meaning where accepted
  };

  /// copies: alike, as are_copies() says; they outlive the batch. kinds: of each position in the
  /// state. guess: from which a step starts.
  LaneBatch(std::span<Copy> copies, const CopyKernels& kernels, const std::vector<StateKind>& kinds,
            Guess guess);

  std::span<Copy> copies() const { return copies_; }
  unsigned all() const { return (1u << copies_.size()) - 1; }

  /// See PartInputs.
  std::vector<int> drivers() const;
  std::vector<int> reads() const;
  /// See Part.
  void bind(const PartOutputs& outputs);
  void begin_step(const StepHistory& history, const MotionRow& row);
  /// So many numbers of the row are those of its drivers.
  std::size_t in_row() const { return driven_.size() * lanes_; }
  /// Whether the step starts from the instant before, which is kept, and not from the state.
  bool predicted() const { return predicted_; }
  void forget() { assembled_ = kept_ = predicted_ = is_driven_ = false; }

  /// Solves positions, velocities and accelerations of all copies, where the kernels may go on;
  /// otherwise none is accepted. What is not accepted is of no meaning.
  const Step& solve(const State& state);
  /// Takes what the copies have found by themselves.
  void take(const State& state);

  void deliver(const OutputView& output, Level level) const;

  /// Writes what is observed in the state, as far as `level`; without prediction all positions.
  void write_observed(State& state, Level level) const;
  /// Writes all of one copy.
  void store(std::size_t copy, State& state) const { store(own_, copy, state); }
  /// Writes its drivers, which it reads in the state when it is solved alone.
  void store_drivers(std::size_t copy, State& state) const { store(driven_, copy, state); }
  /// Writes its positions of the instant before.
  void restore(std::size_t copy, std::span<double> q) const;

 private:
  LaneTargets targets(std::span<const int> numbers, std::span<int> places) const;
  template <std::size_t lanes>
  void drive(MotionRow row);
  void store(std::span<const int> numbers, std::size_t copy, State& state) const;
  void scatter(const LaneTargets& targets, Level level, const OutputView& to) const;
  template <class Visit>
  void for_numbers(std::span<const int> numbers, std::size_t lane, Visit&& visit) const;

  std::span<Copy> copies_;
  std::vector<LaneStage> stages_;
  std::size_t lanes_;
  LanePlaces places_;  // in the state, of all that a copy reads and writes: local inputs
  std::vector<int> unknowns_, driven_;  // local, ascending …
  std::vector<int> own_;                // … and both
  LaneSources constants_, moving_;      // of others: once, and in every step
  LaneSources undriven_;                // of drivers, where no step was begun
  LaneSources starts_;                  // of its own
  std::vector<int> unwrapped_;          // of these, angles that start at their last value
  LaneTargets observed_, delivered_;
  std::unique_ptr<std::array<LaneState, 2>> states_;  // these two, in turn
  LaneState *now_, *before_;
  Predictor predictor_;
  LaneValues residuals2_;  // of each stage, for the most lanes
  Step step_;
  bool assembled_ = false;  // every part has found a position since forget()
  bool kept_ = false, predicted_ = false, is_driven_ = false;
};

/// Whether both have parts of the same types, in the same order, that take the same from each
/// other.
bool are_copies(std::span<const ExplicitPart* const> a, std::span<const ExplicitPart* const> b);

}  // namespace desmo
