#include "formulations/verification/range/singular_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "formulations/verification/range/locked_loops.h"

namespace desmo {

namespace {

using Point = SolutionCurve::Point;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Writes to an end the loops that lock and the constraints that hold them. Moves `beyond` by what
/// rounding of Φ may change, and by the spacing of doubles there.
void name_culprits(SolutionCurve& curve, LockedLoops locked, const Point& point, double direction,
                   RangeEnd& e) {
  e.groups = std::move(locked.groups);
  e.moving = std::move(locked.moving);
  const auto [forces, rounding] = curve.forces(point);
  e.beyond += direction * (rounding + epsilon * std::abs(e.beyond));
  for (std::size_t c = 0; c < forces.size(); ++c)
    if (forces[c] > curve.limits().locking_arc()) e.constraints.push_back(static_cast<int>(c));
  std::ranges::stable_sort(e.constraints, std::greater{}, [&forces](int c) { return forces[c]; });
}

}  // namespace

bool turns_twice(const SolutionCurve& curve, const Point& from, const Point& to, double length,
                 double direction) {
  const double first = direction * from.speed(), last = direction * to.speed(),
               mean = direction * (curve.value(to) - curve.value(from)) / curve.scale() / length;
  return first > 0 && last > 0 && 1.5 * mean - (first + last) / 4 <= 0;
}

std::optional<DeadPoint> find_dead_point(const Model& m, SolutionCurve& curve, const Point& from,
                                         const EarlierPoint& far, double length, double direction) {
  const auto forward = [&](const Point& p) { return direction * p.speed(); };
  Point low = from;
  std::optional<Point> high = curve.step(from, length);
  double at_low = 0, at_high = length;
  // False position, with a weight halved when its end stays (Illinois' method).
  double weight_low = forward(low), weight_high = -forward(*high);
  // The speed falls towards the dead point. So the driver's value at either end is off by at most
  // its speed × the arc between both.
  while (std::min(forward(low), -forward(*high)) * (at_high - at_low) > epsilon) {
    const double at = at_low + (at_high - at_low) * weight_low / (weight_low + weight_high);
    std::optional<Point> middle = curve.step(from, at);
    if (!middle) return {};
    if (!(at > at_low && at < at_high)) break;
    if (forward(*middle) > 0) {
      low = *std::move(middle), at_low = at;
      weight_low = forward(low), weight_high /= 2;
    } else {
      high = std::move(middle), at_high = at;
      weight_high = -forward(*high), weight_low /= 2;
    }
  }
  const auto reached = [&](const Point& p) { return direction * curve.value(p); };
  const auto farther = [&](const Point& p) {
    const double along = p.tangent.dot(from.tangent) / from.tangent.squaredNorm();
    return (at_high - at_low) * curve.scale() * std::abs(p.speed()) / along;
  };
  const double most = std::min(reached(low) + farther(low), reached(*high) + farther(*high));
  const Point& last = reached(low) > reached(*high) ? low : *high;
  RangeEnd e{.stop = RangeStop::dead_point, .value = curve.value(last)};
  e.beyond = direction * std::max(most, reached(last));
  if (!(std::abs(e.beyond - e.value) < curve.limits().accuracy * curve.scale())) return {};
  const bool is_low = forward(low) < -forward(*high);
  const Point& nearest = is_low ? low : *high;
  const LockedLoops first = first_locked_loop(m, curve, nearest);
  const std::optional<Point> before =
      curve.step(far.point, far.arc + (is_low ? at_low : at_high) - curve.limits().locking_arc());
  LockedLoops all = before ? find_locked_loops(m, curve, *before, nearest) : first;
  // Rounding may hide that singular values fall. The tangent then still tells one of the loops.
  const bool is_seen = std::ranges::find(all.groups, first.groups.front()) != all.groups.end();
  name_culprits(curve, is_seen ? std::move(all) : first, nearest, direction, e);
  return DeadPoint{std::move(e), *std::move(high)};
}

std::optional<RangeEnd> find_joint_lock(const Model& m, SolutionCurve& curve, const Point& before,
                                        const Point& last, double direction) {
  const double locking_arc = curve.limits().locking_arc();
  const double speed = direction * before.speed(),
               mean = direction * (curve.value(last) - curve.value(before)) / curve.scale() /
                      locking_arc;
  // A speed that falls linearly from `before` is 2 mean − speed at `last`: it must have halved.
  if (!(speed > 0 && 2 * mean - speed < speed / 2)) return {};
  RangeEnd e{
      .stop = RangeStop::dead_point, .value = curve.value(last), .beyond = curve.value(last)};
  // The tangent so near to a crossing may be that of any curve: takes the earlier one.
  const Point end{last.state, before.tangent, last.sign, last.log_determinant};
  LockedLoops locked = find_locked_loops(m, curve, before, end);
  if (locked.moving.empty()) return {};
  const double left = locked.left;
  name_culprits(curve, std::move(locked), end, direction, e);
  // The speed at `last` times the arc that is left from there, at most.
  const double beyond = (left * speed) * (2 * left * locking_arc);
  if (!(beyond < curve.limits().accuracy)) return {};
  e.beyond += direction * beyond * curve.scale();
  return e;
}

double interpolated(std::span<const double> xs, std::span<const double> ys, double x) {
  double y = 0;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < xs.size(); ++j)
      if (j != i) weight *= (x - xs[j]) / (xs[i] - xs[j]);
    y += weight * ys[i];
  }
  return y;
}

double find_crossing(SolutionCurve& curve, const EarlierPoint& before, double length,
                     std::size_t blocks) {
  const double apart = curve.limits().crossing_distance();
  std::vector<double> determinants, values;
  const Point& from = before.point;
  const double arc = before.arc + length;
  for (const auto& [nearest, side] : {std::pair(0.0, -1.0), std::pair(arc, 1.0)})
    for (const int i : {1, 2})
      if (const std::optional<Point> p = curve.step(from, nearest + side * i * apart)) {
        determinants.push_back(side *
                               std::exp((p->log_determinant - from.log_determinant) /
                                        static_cast<double>(std::max<std::size_t>(1, blocks))));
        values.push_back(curve.value(*p));
      }
  const double value = interpolated(determinants, values, 0);
  const bool is_known = values.size() == 4 && std::isfinite(value);
  if (is_known) return value;
  const std::optional<Point> to = curve.step(from, arc);
  return to ? (curve.value(from) + curve.value(*to)) / 2 : curve.value(from);
}

}  // namespace desmo
