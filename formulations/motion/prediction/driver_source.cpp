#include "formulations/motion/prediction/driver_source.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace desmo {

void write_drivers(const Model& m, double t, State& state) {
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    const MotionSample<double> z = sample(d.motion, t);
    state.q[i] = z.position;
    state.qd[i] = z.velocity;
    state.qdd[i] = z.acceleration;
  }
}

DriverSource::DriverSource(const Model& m, std::span<const int> in_row)
    : in_row_(m.state_size()), motions_({}) {
  const PlacedMotions all = driver_motions(m);
  std::vector<const Motion*> sampled;
  std::vector<int> driver(m.state_size());  // position in Model::drivers of each driven coordinate
  for (std::size_t i = 0; i < all.places.size(); ++i) driver[all.places[i]] = static_cast<int>(i);
  std::vector<int> place(m.state_size(), -1);
  const auto add = [&](int coordinate) {
    place[coordinate] = static_cast<int>(sampled.size());
    sampled.push_back(all.motions[driver[coordinate]]);
    handed_in_.push_back({driver[coordinate], coordinate});
  };
  for (const int coordinate : in_row) {
    add(coordinate);
    in_row_[coordinate] = true;
  }
  for (const int coordinate : all.places) {
    if (place[coordinate] < 0) add(coordinate);
    drivers_.push_back({coordinate, place[coordinate]});
  }
  written_ = drivers_;
  motions_ = MotionsAhead(std::move(sampled));
  const std::size_t size = whole_lines(handed_in_.size());
  for (LaneState* row : {&live_, &between_}) row->resize(size);
  from_.resize(size);
}

void DriverSource::hand_in(const LiveRow& row, double start, const State& from) {
  const auto copy = [&](std::span<const double> values, LaneValues& to) {
    for (std::size_t k = 0; k < handed_in_.size(); ++k)
      to[k] = values.empty() ? 0 : values[handed_in_[k].driver];
  };
  copy(row.z, live_.q);
  copy(row.zd, live_.qd);
  copy(row.zdd, live_.qdd);
  for (std::size_t k = 0; k < handed_in_.size(); ++k) from_[k] = from.q[handed_in_[k].coordinate];
  live_time_ = row.time;
  start_ = start;
  is_live_ = true;
}

MotionRow DriverSource::live_row(double t) {
  if (t == live_time_) return {live_.q.data(), live_.qd.data(), live_.qdd.data()};
  const double whole = live_time_ - start_, share = (t - start_) / whole;
  for (std::size_t k = 0; k < handed_in_.size(); ++k) {
    const double way = live_.q[k] - from_[k];
    between_.q[k] = from_[k] + share * way;
    between_.qd[k] = way / whole;
  }
  return {between_.q.data(), between_.qd.data(), between_.qdd.data()};
}

void DriverSource::write_all(State& state) const {
  if (row_.z) write(drivers_, state);
}

void DriverSource::set_observed(const std::vector<bool>& read) {
  written_.clear();
  std::ranges::copy_if(drivers_, std::back_inserter(written_), [&](const Driven& d) {
    return read[d.coordinate] || !in_row_[d.coordinate];
  });
}

}  // namespace desmo
