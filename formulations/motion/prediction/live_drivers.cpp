#include "formulations/motion/prediction/live_drivers.h"

#include <cstddef>
#include <utility>

namespace desmo {

LiveDrivers::LiveDrivers(std::vector<Place> places) : places_(std::move(places)) {
  const std::size_t size = whole_lines(places_.size());
  for (LaneState* row : {&row_, &between_}) row->resize(size);
  from_.resize(size);
}

void LiveDrivers::hand_in(const LiveRow& row, double start, const State& from) {
  const auto copy = [&](std::span<const double> values, LaneValues& to) {
    for (std::size_t k = 0; k < places_.size(); ++k)
      to[k] = values.empty() ? 0 : values[places_[k].driver];
  };
  copy(row.z, row_.q);
  copy(row.zd, row_.qd);
  copy(row.zdd, row_.qdd);
  for (std::size_t k = 0; k < places_.size(); ++k) from_[k] = from.q[places_[k].coordinate];
  time_ = row.time;
  start_ = start;
  is_handed_in_ = true;
}

MotionRow LiveDrivers::at(double t) {
  if (t == time_) return {row_.q.data(), row_.qd.data(), row_.qdd.data()};
  const double whole = time_ - start_, share = (t - start_) / whole;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const double way = row_.q[k] - from_[k];
    between_.q[k] = from_[k] + share * way;
    between_.qd[k] = way / whole;
  }
  return {between_.q.data(), between_.qd.data(), between_.qdd.data()};
}

}  // namespace desmo
