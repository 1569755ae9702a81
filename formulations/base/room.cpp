#include "formulations/base/room.h"

#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace desmo {

namespace {

void refuse(int coordinate, const char* why) {
  throw std::invalid_argument("a sink has room for coordinate " + std::to_string(coordinate) + why);
}

}  // namespace

std::vector<int> coordinates_in_room(std::span<const int> named, int of_mechanism) {
  std::vector<int> all(named.begin(), named.end());
  if (all.empty()) {
    all.resize(of_mechanism);
    std::iota(all.begin(), all.end(), 0);
  }
  std::vector<bool> has_room(of_mechanism);
  for (const int i : all) {
    if (i < 0 || i >= of_mechanism) refuse(i, ", which the mechanism does not have");
    if (has_room[i]) refuse(i, " twice");
    has_room[i] = true;
  }
  return all;
}

void RoomPool::add() {
  constexpr std::size_t line = LaneAllocator<double>::alignment / sizeof(double);
  const std::size_t apart = (size_ + line - 1) / line * line;
  double* const q =
      memory_.emplace_back(3 * apart, std::numeric_limits<double>::quiet_NaN()).data();
  free_.reserve(memory_.size());
  free_.push_back({q, level_ >= Level::velocity ? q + apart : nullptr,
                   level_ >= Level::acceleration ? q + 2 * apart : nullptr});
}

}  // namespace desmo
