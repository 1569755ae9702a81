#include "formulations/stepping/trajectory.h"

#include <algorithm>

namespace desmo {

Trajectory::Trajectory(int instants, int coordinates)
    : coordinates_(static_cast<std::size_t>(coordinates)),
      times_(instants),
      updates_(instants),
      residuals_(instants) {}

void Trajectory::observe(const Instant& instant) {
  times_[instant.index] = instant.time;
  updates_[instant.index] = instant.updates;
  residuals_[instant.index] = instant.residual;
  keep(q_, instant, instant.q);
  keep(qd_, instant, instant.qd);
  keep(qdd_, instant, instant.qdd);
}

void Trajectory::keep(Values& values, const Instant& instant, std::span<const double> given) {
  if (given.empty()) return;
  if (!values.known) values.of_all.resize(times_.size() * coordinates_);
  values.known = true;
  std::ranges::copy(
      given, values.of_all.begin() + static_cast<std::ptrdiff_t>(instant.index * coordinates_));
}

std::span<const double> Trajectory::kept(const Values& values, std::size_t instant) const {
  if (!values.known) return {};
  return std::span(values.of_all).subspan(instant * coordinates_, coordinates_);
}

void Trajectory::hand_on(Observer& observer) const {
  for (std::size_t i = 0; i < times_.size(); ++i)
    observer.observe({static_cast<int>(i), times_[i], kept(q_, i), kept(qd_, i), kept(qdd_, i),
                      updates_[i], residuals_[i]});
}

}  // namespace desmo
