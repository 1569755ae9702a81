#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/stepping/keeper.h"

namespace desmo {

/// The parts of a formulation that keep what they find, and how their results and those of the
/// others come together in rooms.
class Keepers {
 public:
  void clear();
  /// level: as far as anyone asks for its unknowns.
  void add(Keeper& keeper, Level level);
  bool empty() const { return keepers_.empty(); }

  /// Driven coordinates, as Keeper::drivers(), one keeper behind the other.
  std::span<const int> drivers() const { return drivers_; }
  /// See Keeper, of all. row: begins with these drivers.
  void begin_step(const StepHistory& history, const MotionRow& row);
  void write_last(std::span<double> q) const;
  void write(State& state) const;

  /// From now on outputs are of this request. Throws as requested_coordinates() does.
  void bind(const Request& request, const Model& model);
  /// Coordinates that outputs are given from the state.
  const std::vector<int>& not_kept() const { return not_kept_; }
  /// Writes the output of the instant solved last, as far as `level`: what is not kept from the
  /// state, which it shows.
  void deliver(Instant& instant, Level level) const;

 private:
  struct Kept {
    Keeper* keeper;
    Level level;
    std::size_t first_driver;
  };
  std::vector<Kept> keepers_;
  std::vector<int> drivers_;
  std::vector<int> not_kept_;
  OutputWriter from_state_;
};

}  // namespace desmo
