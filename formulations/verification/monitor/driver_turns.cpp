#include "formulations/verification/monitor/driver_turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace desmo {

namespace {

/// Of a step, in which turning points are looked for one by one.
constexpr int pieces = 16;
/// Of a step, at its ends: a turn so near is that of the instant itself.
constexpr double end_share = 1e-6;

/// Returns the shortest time in which a motion may turn twice.
double shortest_time(const Motion& motion) {
  if (const auto* spline = std::get_if<Spline>(&motion)) {
    double shortest = INFINITY;
    for (std::size_t i = 1; i < spline->knots().size(); ++i)
      shortest = std::min(shortest, spline->knots()[i] - spline->knots()[i - 1]);
    return shortest;
  }
  double fastest = 0;
  if (const auto* sum = std::get_if<HarmonicSum>(&motion))
    for (const HarmonicSum::Term& term : sum->terms)
      fastest = std::max(fastest, std::abs(term.angular_frequency));
  return fastest > 0 ? std::numbers::pi / 2 / fastest : INFINITY;
}

}  // namespace

DriverTurns::DriverTurns(const Model& m, const TimeGrid& grid, std::span<const double> magnitudes)
    : model_(m) {
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    driven_.push_back({i, 1 / magnitudes[i]});
    is_coarse_ = is_coarse_ || std::abs(grid.interval()) > shortest_time(d.motion);
  }
}

bool DriverTurns::find(const RecentInstants::Node& from, const Instant& to, double min_excursion) {
  count_ = 0;
  if (to.qd.empty()) return false;
  if (!is_coarse_ && deviation(from, to) < min_excursion) return false;
  const bool is_single = driven_.size() == 1;
  for (std::size_t d = 0; d < driven_.size(); ++d)
    add_turns(model_.drivers[d].motion, from.time, to.time,
              is_single ? min_excursion / driven_[d].unit : 0);
  if (!is_single && !driven_.empty()) add(from.time + (to.time - from.time) / 2);
  std::sort(times_.begin(), times_.begin() + count_);
  return count_ > 0;
}

/// Returns how far the drivers are off the straight way at most, in magnitudes.
double DriverTurns::deviation(const RecentInstants::Node& from, const Instant& to) const {
  const double h = to.time - from.time;
  double most = 0;
  for (const auto& [i, unit] : driven_) {
    const double v0 = from.state.qd[i], v1 = to.qd[i];
    const double off = to.q[i] - from.state.q[i] - h / 2 * (v0 + v1);
    most = std::max(most, (std::abs(h * (v1 - v0)) / 8 + std::abs(off)) * unit);
  }
  return most;
}

/// Adds the turns that lead beyond both ends by that much, in units of the coordinate.
void DriverTurns::add_turns(const Motion& motion, double from, double to, double min_excursion) {
  const auto rate = [&](double t) { return sample(motion, t).velocity; };
  const double z0 = sample(motion, from).position, z1 = sample(motion, to).position;
  const double near_end = end_share * (to - from);
  double before = from, rate_before = rate(from);
  for (int k = 1; k <= pieces; ++k) {
    const double t = k == pieces ? to : from + k * ((to - from) / pieces), v = rate(t);
    if (v * rate_before < 0) {
      double low = before, high = t;
      for (double middle; (middle = low + (high - low) / 2) != low && middle != high;)
        (rate(middle) * rate_before > 0 ? low : high) = middle;
      const double z = sample(motion, low).position;
      const bool is_inside = low > from + near_end && low < to - near_end;
      if (is_inside && std::min(std::abs(z - z0), std::abs(z - z1)) >= min_excursion) add(low);
    }
    if (v != 0) before = t, rate_before = v;
  }
}

void DriverTurns::add(double time) {
  if (count_ < static_cast<int>(times_.size())) times_[count_++] = time;
}

}  // namespace desmo
