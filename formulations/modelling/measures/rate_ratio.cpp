#include "formulations/modelling/measures/rate_ratio.h"

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cases/mechanism/motion.h"
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

/// A driver's coordinate and, unless its rates come from rows of numbers, its motion.
struct DriverRate {
  int coordinate;
  std::optional<Motion> motion;
};

}  // namespace

Measures::Rule rate_ratio(const Model& m, const std::array<int, 2>& of,
                          Measures::DrivenBy driven_by) {
  std::vector<DriverRate> drivers;
  for (const Driver& d : m.drivers) {
    drivers.push_back({m.entities[d.coordinate].first, std::nullopt});
    if (driven_by == Measures::DrivenBy::motions) drivers.back().motion = d.motion;
  }
  return [a = of[0], b = of[1], magnitude = nominal_magnitudes(m), drivers = std::move(drivers)](
             const Instant& instant, std::span<PerLevel<double>> values) {
    // Returns the largest rate of a driver, divided by the driver's magnitude. Rates that vanish by
    // their motion do not count.
    const auto fastest_driver = [&](std::span<const double> rates, Level level) {
      double largest = 0;
      for (const auto& [i, motion] : drivers) {
        const double rate = std::abs(rates[i]) / magnitude[i];
        if (rate > largest && !(motion && vanishes(*motion, instant.time, level))) largest = rate;
      }
      return largest;
    };
    // Returns whether a rate vanishes compared with those of drivers (scale); true when these do.
    const auto is_nothing = [&](std::span<const double> rates, int coordinate, double scale) {
      return scale == 0 ||
             std::abs(rates[coordinate]) / magnitude[coordinate] <= Measures::min_rate * scale;
    };
    double& ratio = values[0].velocity;
    ratio = std::numeric_limits<double>::quiet_NaN();  // it is not known
    if (instant.qd.empty()) return;
    const double speed = fastest_driver(instant.qd, Level::velocity);
    if (!is_nothing(instant.qd, b, speed)) {
      ratio = instant.qd[a] / instant.qd[b];
      return;
    }
    if (instant.qdd.empty() || !is_nothing(instant.qd, a, speed)) return;
    const double change = fastest_driver(instant.qdd, Level::acceleration);
    if (!is_nothing(instant.qdd, b, change + speed * speed))
      ratio = instant.qdd[a] / instant.qdd[b];
  };
}

}  // namespace desmo
