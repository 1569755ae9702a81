#pragma once

#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/state.h"

namespace desmo {

struct MotionRow;    // defined in motion/prediction/motions_ahead.h
struct OutputView;   // defined in base/output.h
struct StepHistory;  // defined in motion/prediction/guess.h

/// The places where the parts put their results in a run.
struct PartOutputs {
  /// For each position in the state, whether it is read there by other parts, by the prediction, or
  /// by an observer that lends no memory.
  const std::vector<bool>& observed;
  /// For each position in the state its place in the outputs that an observer lends, or −1. A part
  /// sets to −1 what it delivers itself. Empty: none are lent.
  std::span<int> places;
  Level level;  ///< highest level at which the part's unknowns are requested
};

/// The further duties of a part, such as a batch, that keeps what it finds in a layout of its own
/// from one instant to the next. It predicts from there, and writes to the state only what is
/// observed there.
class ResidentPart {
 public:
  virtual ~ResidentPart() = default;

  /// Fixes, before a run, where results go. Until then all are written to the state.
  virtual void bind(const PartOutputs& outputs) = 0;
  /// Begins a step.
  /// - history: of the instants solved; the part keeps the last one. Where that is unknown, as
  ///   after a failure, the positions in the state are complete: solve() starts from these, and
  ///   leaves all positions there.
  /// - row: begins with PartInputs::drivers at the instant to come
  virtual void begin_step(const StepHistory& history, const MotionRow& row) = 0;
  /// Writes the instant solved last to an output, up to `level`, as bound.
  virtual void deliver(const OutputView& output, Level level) const = 0;
  /// Writes the instant solved last to the state: unknowns, and drivers taken from the row.
  virtual void store(State& state) const = 0;
  /// Writes the positions of the instant before the one that was solved or tried last. Writes
  /// nothing where the last one did not start from a prediction.
  virtual void restore(std::span<double> q) const = 0;
};

}  // namespace desmo
