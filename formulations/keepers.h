#pragma once

#include <span>
#include <vector>

#include "formulations/keeper.h"

namespace desmo {

/// The parts of a formulation that keep what they find, and how their results and those of the
/// others come together in rooms.
class Keepers {
 public:
  void clear() { keepers_.clear(); }
  /// level: as far as anyone asks for its unknowns.
  void add(Keeper& keeper, Level level) { keepers_.push_back({&keeper, level}); }
  bool empty() const { return keepers_.empty(); }

  /// See Keeper, of all.
  void begin_step(const Past& past);
  void write_last(std::span<double> q) const;
  void write(State& state) const;

  /// From now on rooms are for these of a mechanism's coordinates; none stands for all. Throws
  /// std::invalid_argument where one is named twice or does not exist.
  void prepare_rooms(std::span<const int> coordinates, int of_mechanism);
  /// Puts the instant solved last into a room, as far as `level`: what is not kept from the state.
  void fill(const Room& room, Level level, const State& state) const;

 private:
  struct Kept {
    Keeper* keeper;
    Level level;
  };
  struct CoordinateInRoom {
    int coordinate, slot;
  };
  std::vector<Kept> keepers_;
  std::vector<CoordinateInRoom> not_kept_;
};

}  // namespace desmo
