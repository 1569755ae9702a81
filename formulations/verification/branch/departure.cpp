#include "formulations/verification/branch/departure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/path_proof.h"

namespace desmo {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

PerLevel<std::vector<double>> drivers_at(const Model& m, double time) {
  PerLevel<std::vector<double>> z;
  for (const Driver& d : m.drivers) {
    const MotionSample<double> x = sample(d.motion, time);
    z.position.push_back(x.position);
    z.velocity.push_back(x.velocity);
    z.acceleration.push_back(x.acceleration);
  }
  return z;
}

std::vector<double> exact_drivers_at(const Model& m, double time) {
  std::vector<double> z;
  for (const Driver& d : m.drivers) {
    const auto [value, correction, radius] = sample(d.motion, Compensated<double>(time)).position;
    z.push_back(value + correction);
  }
  return z;
}

/// Doubles steps from each knot on, since drivers that rest there depart as a power of time.
/// Doubled steps also reach infinity, where the search ends.
double Departure::time_at(double distance) const {
  const auto is_away = [&](double t) {
    return line_.distance(drivers_at(m_, t).position, 0) >= distance;
  };
  if (is_away(start_)) return start_;
  double begin = start_, inside = start_, step = 0;
  const auto next_knot = [&] { return first_knot(m_, begin, infinity).value_or(infinity); };
  for (double knot = next_knot();;) {
    step = std::max(2 * step, std::nextafter(begin, infinity) - begin);
    double next = std::min(begin + step, knot);
    if (next == infinity) return infinity;
    if (is_away(next)) {
      for (int i = 0; i < 64; ++i) {  // bisects
        const double middle = inside + (next - inside) / 2;
        (is_away(middle) ? next : inside) = middle;
      }
      return next;
    }
    inside = next;
    if (next == knot) begin = knot, step = 0, knot = next_knot();
  }
}

bool Departure::has_corner(double near, double far) const {
  if (line_.count() == 1) return false;
  const double first = time_at(near), second = time_at(far);
  if (second == infinity) return true;  // the path is too short to tell
  const std::vector<double> z = drivers_at(m_, first).position,
                            far_off = drivers_at(m_, second).position;
  double rounding = 0;
  for (std::size_t k = 0; k < z.size(); ++k)
    rounding += 4 * Interval::unit * std::abs(z[k]) / line_.magnitudes[k];
  const double off = line_.distance(z, line_.arc(z)),
               sine = line_.distance(far_off, line_.arc(far_off)) / line_.distance(far_off, 0);
  return off > rounding && off / near > sine / 2;
}

}  // namespace desmo
