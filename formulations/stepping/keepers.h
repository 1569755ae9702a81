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

  /// From now on rooms are for these coordinates of a mechanism; none stands for all. Throws
  /// std::invalid_argument where one is named twice or does not exist.
  void prepare_rooms(std::span<const int> coordinates, const Model& model);
  /// Coordinates that rooms are given from the state.
  std::vector<int> not_kept() const;
  /// Puts the instant solved last into a room, as far as `level`: what is not kept from the state.
  void fill(const Room& room, Level level, const State& state) const;

 private:
  struct Kept {
    Keeper* keeper;
    Level level;
    std::size_t first_driver;
  };
  struct CoordinateInRoom {
    int coordinate, slot;
  };
  std::vector<Kept> keepers_;
  std::vector<int> drivers_;
  std::vector<CoordinateInRoom> not_kept_;
};

}  // namespace desmo
