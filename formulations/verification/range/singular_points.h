#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "formulations/model/model.h"
#include "formulations/verification/range/driver_range.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// Dead point of a curve, and a point beyond it.
struct DeadPoint {
  RangeEnd end;
  SolutionCurve::Point after;
};

/// A point of a curve so far from a later one that its tangent is known well, and the arc between.
struct EarlierPoint {
  SolutionCurve::Point point;
  double arc = 0;
};

/// Returns whether the driver may turn back and forth within a step: it goes forward at both ends,
/// but its speed in the middle, by Simpson's rule, is not forward. direction: 1 or −1.
bool turns_twice(const SolutionCurve& curve, const SolutionCurve::Point& from,
                 const SolutionCurve::Point& to, double length, double direction);

/// Finds the dead point in a step at whose end the driver goes back. The driver's value is
/// stationary there, so it is known far better than the position. Returns nothing where it cannot
/// be bracketed to the accuracy. direction: of the driver before, 1 or −1.
std::optional<DeadPoint> find_dead_point(const Model& model, SolutionCurve& curve,
                                         const SolutionCurve::Point& from, const EarlierPoint& far,
                                         double length, double direction);

/// Finds the dead point just beyond the last point to which a curve can be followed, where several
/// loops lock at once: curves cross there, and det B vanishes, too. The driver's speed and singular
/// values of Φ_φ fall like the distance. Returns nothing where they do not, or the driver's value
/// is not known to the accuracy. before: a locking_arc from the last point.
std::optional<RangeEnd> find_joint_lock(const Model& model, SolutionCurve& curve,
                                        const SolutionCurve::Point& before,
                                        const SolutionCurve::Point& last, double direction);

/// Returns at x Lagrange's polynomial through points (xs, ys).
double interpolated(std::span<const double> xs, std::span<const double> ys, double x);

/// Returns the driver's value at a crossing in a step of a length, a little after an earlier
/// point. Positions next to a crossing are not well known; so the value at which det B vanishes is
/// interpolated from points further away, to which the curve leads from the earlier one. det B
/// vanishes like the distance to the power of the number of blocks that become singular.
double find_crossing(SolutionCurve& curve, const EarlierPoint& before, double length,
                     std::size_t blocks);

}  // namespace desmo
