#pragma once

#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/state.h"

namespace desmo {

struct MotionRow;    // defined in motion/prediction/motions_ahead.h
struct OutputView;   // defined in base/output.h
struct StepHistory;  // defined in motion/prediction/guess.h

/// The places where a part puts its results in a run. `observed` and `places` have an entry for
/// each number of the state.
struct PartOutputs {
  /// True: other parts, the prediction or an observer that lends no memory read the number in the
  /// state.
  const std::vector<bool>& observed;
  /// Index of the number in an output that an observer lends, or −1. A part sets to −1 the numbers
  /// that it delivers itself. Empty: no outputs are lent.
  std::span<int> places;
  Level level;  ///< highest level at which the part's unknowns are requested
};

/// Interface of a part, such as a batch, that keeps its results in a layout of its own from one
/// instant to the next. It predicts from them, and writes to the state only what is observed there.
class ResidentPart {
 public:
  virtual ~ResidentPart() = default;

  /// Fixes, before a run, where results go. Before the first call all results go to the state.
  virtual void bind(const PartOutputs& outputs) = 0;
  /// Begins a step.
  /// - history: knowledge of the instants solved before; the part keeps their values. Where the
  ///   last one is unknown, as after a failure, the state has all positions of the part. solve()
  ///   then starts from these, and writes all its positions to the state.
  /// - row: driver values at the instant to come; those of PartInputs::drivers come first
  virtual void begin_step(const StepHistory& history, const MotionRow& row) = 0;
  /// Writes the instant solved last to an output, up to `level`, at the places given to bind().
  virtual void deliver(const OutputView& output, Level level) const = 0;
  /// Writes the instant solved last to the state: unknowns, and drivers taken from the row.
  virtual void store(State& state) const = 0;
  /// Writes the part's positions at the instant before the last one, solved or failed, to q, which
  /// is laid out like State::q. Writes nothing where the last one did not start from a prediction.
  virtual void restore(std::span<double> q) const = 0;
};

}  // namespace desmo
