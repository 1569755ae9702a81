#include "formulations/stepping/keepers.h"

#include <algorithm>
#include <iterator>

namespace desmo {

void Keepers::clear() {
  keepers_.clear();
  drivers_.clear();
}

void Keepers::add(Keeper& keeper, Level level) {
  keepers_.push_back({&keeper, level, drivers_.size()});
  std::ranges::copy(keeper.drivers(), std::back_inserter(drivers_));
}

void Keepers::begin_step(const StepHistory& history, const MotionRow& row) {
  for (const auto& [keeper, level, first_driver] : keepers_)
    keeper->begin_step(history.up_to(level), row.from(first_driver));
}

void Keepers::write_last(std::span<double> q) const {
  for (const Kept& kept : keepers_) kept.keeper->write_last(q);
}

void Keepers::write(State& state) const {
  for (const Kept& kept : keepers_) kept.keeper->write(state);
}

void Keepers::prepare_rooms(std::span<const int> coordinates, const Model& model) {
  const std::vector<int> named = coordinates_in_room(coordinates, model.coordinates());
  std::vector<int> slots(model.state_size(), -1);
  for (std::size_t n = 0; n < named.size(); ++n) slots[named[n]] = static_cast<int>(n);
  for (const Kept& kept : keepers_)  // what is filled to a lower level has drivers up to that only
    kept.keeper->prepare_rooms(slots, kept.level == Level::acceleration);
  not_kept_.clear();
  for (const int i : named)
    if (slots[i] >= 0) not_kept_.push_back({i, slots[i]});
}

std::vector<int> Keepers::not_kept() const {
  std::vector<int> coordinates;
  for (const CoordinateInRoom& c : not_kept_) coordinates.push_back(c.coordinate);
  return coordinates;
}

void Keepers::fill(const Room& room, Level level, const State& s) const {
  for (const Kept& kept : keepers_) kept.keeper->fill(room, std::min(level, kept.level));
  const auto copy = [&](Level needed, const std::vector<double>& from, double* to) {
    if (!to || level < needed) return;
    for (const auto& [coordinate, slot] : not_kept_) to[slot] = from[coordinate];
  };
  copy(Level::position, s.q, room.q);
  copy(Level::velocity, s.qd, room.qd);
  copy(Level::acceleration, s.qdd, room.qdd);
}

}  // namespace desmo
