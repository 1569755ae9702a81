#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "cases/level.h"

namespace desmo {

/// Which values of an instant are wanted in a room: those of some requested coordinates, one behind
/// the other, up to a level.
struct RoomShape {
  std::span<const int> coordinates;  ///< each once; none standing for all, in their order
  Level level;
};

/// Where they are wanted. Null beyond the level.
struct Room {
  double *q, *qd, *qdd;
};

/// So many instants may be under way at once, with a room each.
inline constexpr std::size_t most_rooms = 8;

/// As many rooms of one shape.
class RoomRing {
 public:
  /// size: how many coordinates the shape stands for.
  RoomRing(RoomShape shape, std::size_t size)
      : coordinates_(shape.coordinates.begin(), shape.coordinates.end()),
        level_(shape.level),
        size_(size),
        values_(3 * size * most_rooms, std::numeric_limits<double>::quiet_NaN()) {}

  RoomShape shape() const { return {coordinates_, level_}; }
  std::size_t size() const { return size_; }

  /// The room of the next instant; most_rooms in a row at most.
  Room take() { return room(taken_++); }
  /// That of the instant taken first, which has come. It holds its values until the next take().
  Room give_back() {
    const Room first = room(given_back_++);
    if (given_back_ == taken_) taken_ = given_back_ = 0;
    return first;
  }

 private:
  Room room(std::size_t number) {
    double* const values = values_.data() + 3 * size_ * (number % most_rooms);
    return {values, level_ >= Level::velocity ? values + size_ : nullptr,
            level_ >= Level::acceleration ? values + 2 * size_ : nullptr};
  }

  std::vector<int> coordinates_;
  Level level_;
  std::size_t size_;
  std::vector<double> values_;
  std::size_t taken_ = 0, given_back_ = 0;
};

}  // namespace desmo
