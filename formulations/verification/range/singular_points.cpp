#include "formulations/verification/range/singular_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace desmo {

namespace {

using Point = SolutionCurve::Point;

/// Names the first block that moves while the driver rests, and the equations that hold it.
void name_culprits(const Model& m, SolutionCurve& curve, const Point& point, double direction,
                   RangeEnd& e) {
  constexpr double moves = 1e-5, holds = 1e-6;
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (const PartDefinition& block : curve.blocks()) {
    for (const int i : block.unknowns) {
      const auto j = std::ranges::lower_bound(curve.unknowns(), i) - curve.unknowns().begin();
      if (std::abs(point.tangent[j]) > moves && (e.moving.empty() || e.moving.back() != owner[i]))
        e.moving.push_back(owner[i]);
    }
    if (e.moving.empty()) continue;
    e.group = block.groups.front();
    break;
  }
  const auto [forces, rounding] = curve.forces(point);
  e.beyond += direction * rounding;
  for (std::size_t c = 0; c < forces.size(); ++c)
    if (forces[c] > holds) e.constraints.push_back(static_cast<int>(c));
  std::ranges::stable_sort(e.constraints, std::greater{}, [&forces](int c) { return forces[c]; });
}

}  // namespace

std::optional<DeadPoint> find_dead_point(const Model& m, SolutionCurve& curve, const Point& from,
                                         double length, double direction, double accuracy) {
  constexpr double stationary = 1e-9, margin = 1.2;
  const auto forward = [&](const Point& p) { return direction * p.speed(); };
  Point low = from;
  std::optional<Point> high = curve.step(from, length);
  double at_low = 0, at_high = length;
  double weight_low = forward(low), weight_high = -forward(*high);  // Illinois' method
  for (int i = 0; i < 100 && forward(low) > stationary && -forward(*high) > stationary; ++i) {
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
  // The driver's speed falls between both, so neither end is farther off than at its own speed.
  const auto farther = [&](const Point& p) {
    const double along = p.tangent.dot(from.tangent) / from.tangent.squaredNorm();
    return margin * (at_high - at_low) * curve.scale() * std::abs(p.speed()) / along;
  };
  const double most = std::min(reached(low) + farther(low), reached(*high) + farther(*high));
  const Point& last = reached(low) > reached(*high) ? low : *high;
  RangeEnd e{.stop = RangeStop::dead_point, .value = curve.value(last)};
  e.beyond = direction * std::max(most, reached(last));
  if (!(std::abs(e.beyond - e.value) < accuracy * curve.scale())) return {};
  name_culprits(m, curve, forward(low) < -forward(*high) ? low : *high, direction, e);
  return DeadPoint{std::move(e), *std::move(high)};
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

double find_crossing(SolutionCurve& curve, const Point& from, const Point& to, std::size_t blocks) {
  constexpr double wide = 1e-4;
  std::vector<double> determinants, values;
  for (const auto& [base, side] : {std::pair(&from, -1.0), std::pair(&to, 1.0)})
    for (const double distance : {wide, 2 * wide})
      if (const std::optional<Point> p = curve.step(*base, side * distance)) {
        determinants.push_back(side *
                               std::exp((p->log_determinant - from.log_determinant) /
                                        static_cast<double>(std::max<std::size_t>(1, blocks))));
        values.push_back(curve.value(*p));
      }
  const double value = interpolated(determinants, values, 0);
  const bool is_known = values.size() == 4 && std::isfinite(value);
  return is_known ? value : (curve.value(from) + curve.value(to)) / 2;
}

}  // namespace desmo
