#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/lane_values.h"

namespace desmo {

/// Which values of an instant are wanted in a room: those of some requested coordinates, one behind
/// the other, up to a level.
struct RoomShape {
  std::span<const int> coordinates;  ///< each once; none standing for all, in their order
  Level level;
  int at_once = 1;  ///< asking for rooms of so many instants costs no more than for one
};

/// Those that stand in a room, as RoomShape names them, of a mechanism with so many. Throws
/// std::invalid_argument where one is named twice or does not exist.
std::vector<int> coordinates_in_room(std::span<const int> named, int of_mechanism);

/// Where they are wanted. Null beyond the level.
struct Room {
  double *q = nullptr, *qd = nullptr, *qdd = nullptr;
};

/// Rooms of one shape, as many as are wanted at once. Each begins on cache lines of its own:
/// threads fill several.
class RoomPool {
 public:
  /// size: how many coordinates the shape stands for.
  RoomPool(RoomShape shape, std::size_t size)
      : coordinates_(shape.coordinates.begin(), shape.coordinates.end()),
        level_(shape.level),
        size_(size) {}
  RoomPool(RoomPool&&) = default;  // rooms stay where they are

  RoomShape shape() const { return {coordinates_, level_}; }
  std::size_t size() const { return size_; }

  /// The one given back last, if there is one.
  Room take() {
    if (free_.empty()) add();
    const Room taken = free_.back();
    free_.pop_back();
    return taken;
  }
  /// It holds its values until it is taken again.
  void give_back(const Room& room) { free_.push_back(room); }

 private:
  void add();

  std::vector<int> coordinates_;
  Level level_;
  std::size_t size_;
  std::vector<std::vector<double, LaneAllocator<double>>> memory_;  // of each
  std::vector<Room> free_;
};

}  // namespace desmo
