#include "formulations/modelling/measures/rate_ratio.h"

#include <cmath>
#include <limits>

#include "cases/numbers/compensated.h"
#include "formulations/model/scales.h"

namespace desmo {

namespace {

/// Returns whether a motion's rate may be 0 at a time [s]: whether the rate's enclosure contains 0.
/// The enclosure covers times that differ by ≤ 2⁻⁵² · |time|. So a rounded instant start + i step
/// finds the rest that it is meant to meet.
bool vanishes(const Motion& motion, double time, Level level) {
  using Number = Compensated<double>;
  const Number about{time, 0, 0x1p-52 * std::abs(time)};
  const MotionSample<Number> z = sample(motion, about);
  const Interval rate = (level == Level::velocity ? z.velocity : z.acceleration).enclosure();
  return !(std::abs(rate.mid) > rate.radius);
}

}  // namespace

RateRatio::RateRatio(const Model& m, const std::array<int, 2>& of, Measures::DrivenBy driven_by)
    : of_(of), magnitude_(nominal_magnitudes(m)) {
  for (const Driver& d : m.drivers)
    drivers_.push_back(
        {m.entities[d.coordinate].first, driven_by == Measures::DrivenBy::motions
                                             ? std::make_shared<const Motion>(d.motion)
                                             : nullptr});
}

double RateRatio::operator()(const Instant& instant) const {
  constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
  if (instant.qd.empty()) return not_known;
  const auto [a, b] = of_;
  const double speed = fastest_driver(instant.qd, instant.time, Level::velocity);
  if (!is_nothing(instant.qd, b, speed)) return instant.qd[a] / instant.qd[b];
  if (instant.qdd.empty() || !is_nothing(instant.qd, a, speed)) return not_known;
  const double change = fastest_driver(instant.qdd, instant.time, Level::acceleration);
  return is_nothing(instant.qdd, b, change + speed * speed) ? not_known
                                                            : instant.qdd[a] / instant.qdd[b];
}

/// Returns the largest rate of a driver, divided by the driver's magnitude. Rates that vanish by
/// their motion do not count.
double RateRatio::fastest_driver(std::span<const double> rates, double time, Level level) const {
  double largest = 0;
  for (const auto& [i, motion] : drivers_) {
    const double rate = std::abs(rates[i]) / magnitude_[i];
    if (rate > largest && !(motion && vanishes(*motion, time, level))) largest = rate;
  }
  return largest;
}

/// Returns whether a rate vanishes compared with those of drivers (scale); true when these do.
bool RateRatio::is_nothing(std::span<const double> rates, int coordinate, double scale) const {
  return scale == 0 ||
         std::abs(rates[coordinate]) / magnitude_[coordinate] <= Measures::min_rate * scale;
}

}  // namespace desmo
