#include "formulations/keepers.h"

#include <algorithm>

namespace desmo {

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
  const std::vector<int> named = coordinates_in_room(coordinates, of_mechanism);
  std::vector<bool> kept(of_mechanism);
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
