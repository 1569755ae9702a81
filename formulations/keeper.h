#pragma once

#include <span>
#include <vector>

#include "formulations/guess.h"
#include "formulations/part.h"
#include "formulations/room.h"

namespace desmo {

/// A part that keeps its unknowns from one instant to the next in an order of its own. It makes its
/// own guess, and of what it finds the state holds only what others read there (Part::write_only).
class Keeper {
 public:
  virtual ~Keeper() = default;

  /// Which unknowns are kept: the others are solved as those of any part.
  virtual std::vector<int> kept() const = 0;

  /// Before a step. past: of the instants solved, of which the last is kept; where it is unknown,
  /// as after a failure, solve() starts from the positions in the state, which are then complete,
  /// and leaves all of them there.
  virtual void begin_step(const Past& past) = 0;

  /// Writes positions of the instant before the one solved last, or tried: those from which it was
  /// predicted, and nothing where it was not.
  virtual void write_last(std::span<double> q) const = 0;
  /// Writes the instant solved last.
  virtual void write(State& state) const = 0;

  /// From now on rooms are for these coordinates, each once.
  virtual void prepare_rooms(std::span<const int> coordinates) = 0;
  /// Puts the instant solved last into such a room, as far as `level`.
  virtual void fill(const Room& room, Level level) const = 0;
};

}  // namespace desmo
