// Row 3: singular positions. The plane ones are exact to the last bit: lengths, pivots and the
// angle 0 are floating-point numbers.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "cases/extremes/rows.h"
#include "cases/io/files.h"

namespace desmo::extremes {

namespace {

/// Makes a case whose crank turns from −1 rad to 0 in steps of 1/8 rad, and ends there.
ExtremeCase to_zero(std::string name, const DyadChain& chain) {
  ExtremeCase c = case_of(std::move(name), chain, 1, {0, 0.125, 9});
  c.factor = 100;  // wider than usual for the instants before the singular one
  return c;
}

/// Makes the N-four-bar of the benchmark literature: parallel cranks one after the other, all of
/// them in one line when the crank is at 0.
DyadChain aligned(int dyads) {
  DyadChain chain{.crank = 1, .start = -1, .dyads = {}};
  for (int k = 1; k <= dyads; ++k) add_dyad(chain, 2.0 * k, 2, 1, -1);
  return chain;
}

const Mechanism::Vec& point(const Mechanism& mechanism, const std::string& name) {
  return std::ranges::find(mechanism.points, name, &Mechanism::Point::name)->position;
}

/// Returns the length [m] of a leg of the Stewart platform after a rotation about the vertical
/// axis.
/// - number: "1" … "6"; yaw: angle of the rotation [rad]
double leg_length(const Mechanism& platform, const std::string& number, double yaw) {
  const auto [ax, ay, az] = point(platform, "A" + number);
  const auto [bx, by, bz] = point(platform, "B" + number);
  const double c = std::cos(yaw), s = std::sin(yaw);
  return std::hypot(c * bx - s * by - ax, s * bx + c * by - ay, bz - az);
}

/// Makes a case in which the legs turn the platform by 90° in a second. There their lengths no
/// longer tell which way it turns on (Fichter 1986).
ExtremeCase yawing_platform() {
  constexpr int knots = 101;
  Scene scene = library_scene("stewart");
  for (std::size_t leg = 0; leg < scene.motions.size(); ++leg) {
    std::vector<double> times, lengths;
    for (int i = 0; i < knots; ++i) {
      times.push_back(static_cast<double>(i) / (knots - 1));
      lengths.push_back(leg_length(scene.mechanism, std::to_string(leg + 1),
                                   times.back() * std::numbers::pi / 2));
    }
    scene.motions[leg] = make_spline(std::move(times), std::move(lengths), SplineEnds::natural);
  }
  scene.grid = {0, 0.1, 11};
  ExtremeCase c{.name = "Stewart platform, turned by 90°", .scene = std::move(scene)};
  c.ends_singular = true;
  return c;
}

}  // namespace

std::vector<ExtremeCase> singular_positions(Extent) {
  // "dead point": coupler and rocker, of 5 and 3, are stretched over a distance of 8 at 0.
  return {to_zero("dead point", one_dyad(2, -1, -6, 5, 3)),
          to_zero("parallel cranks in line", aligned(1)),
          to_zero("8 parallel cranks in line", aligned(8)), yawing_platform()};
}

}  // namespace desmo::extremes
