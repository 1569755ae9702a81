#include "formulations/keepers.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace desmo {

namespace {

void refuse(int coordinate, const char* why) {
  throw std::invalid_argument("a sink has room for coordinate " + std::to_string(coordinate) + why);
}

}  // namespace

void Keepers::begin_step(const Past& past) {
  for (const auto& [keeper, level] : keepers_) keeper->begin_step(past.up_to(level));
}

void Keepers::write_last(std::span<double> q) const {
  for (const Kept& kept : keepers_) kept.keeper->write_last(q);
}

void Keepers::write(State& state) const {
  for (const Kept& kept : keepers_) kept.keeper->write(state);
}

void Keepers::prepare_rooms(std::span<const int> coordinates, int of_mechanism) {
  std::vector<int> named(coordinates.begin(), coordinates.end());
  if (named.empty()) {
    named.resize(of_mechanism);
    std::iota(named.begin(), named.end(), 0);
  }
  std::vector<bool> has_room(of_mechanism), kept(of_mechanism);
  for (const int i : named) {
    if (i < 0 || i >= of_mechanism) refuse(i, ", which the mechanism does not have");
    if (has_room[i]) refuse(i, " twice");
    has_room[i] = true;
  }
  for (const auto& [keeper, level] : keepers_) {
    keeper->prepare_rooms(named);
    for (const int i : keeper->kept()) kept[i] = true;
  }
  not_kept_.clear();
  for (std::size_t n = 0; n < named.size(); ++n)
    if (!kept[named[n]]) not_kept_.push_back({named[n], static_cast<int>(n)});
}

void Keepers::fill(const Room& room, Level level, const State& s) const {
  for (const auto& [keeper, as_far_as] : keepers_) keeper->fill(room, std::min(level, as_far_as));
  const auto copy = [&](Level needed, const std::vector<double>& from, double* to) {
    if (!to || level < needed) return;
    for (const auto& [coordinate, slot] : not_kept_) to[slot] = from[coordinate];
  };
  copy(Level::position, s.q, room.q);
  copy(Level::velocity, s.qd, room.qd);
  copy(Level::acceleration, s.qdd, room.qdd);
}

}  // namespace desmo
