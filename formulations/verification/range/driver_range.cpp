#include "formulations/verification/range/driver_range.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "formulations/verification/branch/chosen_equations.h"
#include "formulations/verification/range/driver_sweep.h"

namespace desmo {

DriverRange find_range(const Model& model, std::span<const double> q, int driver,
                       const RangeLimits& limits) {
  if (std::ssize(q) != model.coordinates())
    throw std::invalid_argument("find_range: q has " + std::to_string(q.size()) +
                                " values; the model has " + std::to_string(model.coordinates()) +
                                " coordinates");
  if (driver < 0 || driver >= model.degrees_of_freedom())
    throw std::invalid_argument("find_range: driver " + std::to_string(driver) +
                                " does not exist; the model has " +
                                std::to_string(model.degrees_of_freedom()));
  // The equations that modelling has kept may be dependent at the start.
  const std::unique_ptr<const Model> chosen = with_chosen_equations(model, q);
  const Model& m = chosen ? *chosen : model;
  std::vector<double> state = m.state_of(q);
  SolutionCurve curve(m, driver, limits);
  DriverRange range;
  range.start = state[m.entities[m.drivers[driver].coordinate].first];
  const auto require = [&](bool is_right, const char* what) {
    if (!is_right)
      throw std::runtime_error(std::string(what) + " at the start of driver '" +
                               m.entities[m.drivers[driver].coordinate].name + "'");
  };
  require(std::isfinite(range.start), "no finite value was found");
  range.is_idle = curve.is_idle();
  range.down.value = range.down.beyond = range.up.value = range.up.beyond = range.start;
  if (range.is_idle) return range;

  std::optional<SolutionCurve::Point> start = curve.start(std::move(state));
  if (curve.is_crossing()) {
    range.down.stop = range.up.stop = RangeStop::start;
    return range;
  }
  // At a dead point the driver does not move along the tangent: starts a little further.
  if (start && std::abs(start->speed()) < half_digits) {
    start = curve.step(*start, limits.max_crossing_step);
    if (start && start->speed() < 0) start = SolutionCurve::reversed(*std::move(start));
  }
  require(start && std::abs(curve.value(*start) - range.start) <= limits.accuracy * curve.scale(),
          "no position was found");

  DriverSweep up(m, driver, limits, *start, 1), down(m, driver, limits, *start, -1);
  range.up = up.run();
  if (range.up.stop == RangeStop::full_turn) {
    range.down = range.up;
    range.down.value = range.down.beyond = 2 * range.start - range.up.value;
  } else {
    range.down = down.run();
  }
  for (const auto& [sweep, end] : {std::pair(&up, &range.up), std::pair(&down, &range.down)})
    if (end->stop == RangeStop::dead_point &&
        std::abs(end->value - range.start) < limits.accuracy * curve.scale())
      range.other_branch = sweep->run_after_dead_point();
  for (const DriverSweep* sweep : {&down, &up})
    range.change_points.insert(range.change_points.end(), sweep->change_points().begin(),
                               sweep->change_points().end());
  for (ChangePoint& c : range.change_points)  // a value below the accuracy has no correct digit
    if (std::abs(c.value) < limits.accuracy * curve.scale()) c.value = 0;
  std::ranges::sort(range.change_points, {}, &ChangePoint::value);
  // A double root next to the ends of a full turn is found at both ends: keeps one.
  const auto is_double = [&](const ChangePoint& c, double value) {
    return c.is_double && std::abs(c.value - value) < limits.accuracy * curve.scale();
  };
  const auto [rest, last] = std::ranges::unique(
      range.change_points,
      [&](const ChangePoint& a, const ChangePoint& b) { return is_double(b, a.value); });
  range.change_points.erase(rest, last);
  std::erase_if(range.change_points,
                [&](const ChangePoint& c) { return c.is_double && c.value > range.up.value; });
  return range;
}

}  // namespace desmo
