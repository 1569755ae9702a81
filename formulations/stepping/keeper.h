#pragma once

#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/prediction/guess.h"
#include "formulations/prediction/motions_ahead.h"

namespace desmo {

/// A part that keeps its unknowns from one instant to the next in an order of its own. It makes its
/// own guess, and of what it finds the state holds only what others read there (Part::write_only).
class Keeper {
 public:
  virtual ~Keeper() = default;

  /// Driven coordinates that it reads in a row at the beginning of a step, in the order of the row,
  /// as often as they stand there. What is said below of its unknowns is true of these, too. Where
  /// no step was begun, solve() reads them in the state.
  virtual std::vector<int> drivers() const = 0;
  /// What it reads in the state in every step.
  virtual std::vector<int> reads() const = 0;

  /// Before a step. past: of the instants solved, of which the last is kept; where it is unknown,
  /// as after a failure, solve() starts from the positions in the state, which are then complete,
  /// and leaves all of them there. row: begins with what drivers() do at the instant to come.
  virtual void begin_step(const StepHistory& history, const MotionRow& row) = 0;

  /// Writes positions of the instant before the one solved last, or tried: those from which it was
  /// predicted, and nothing where it was not.
  virtual void write_last(std::span<double> q) const = 0;
  /// Writes the instant solved last.
  virtual void write(State& state) const = 0;

  /// places: for each position in the state, its place in outputs to come, or −1; becomes −1 where
  /// it is this that writes it. drivers_too: or its unknowns alone.
  virtual void prepare_outputs(std::span<int> places, bool drivers_too) = 0;
  /// Writes the instant solved last into such an output, as far as `level`.
  virtual void fill(const OutputView& output, Level level) const = 0;
};

}  // namespace desmo
