#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "formulations/model/model.h"
#include "formulations/verification/range/driver_range.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// Dead point of a curve, and a point of the curve after it.
struct DeadPoint {
  RangeEnd end;
  SolutionCurve::Point after;
};

/// A point of a curve, and the arc from it to the present point. It is so far from a singular one
/// that its tangent is known well.
struct EarlierPoint {
  SolutionCurve::Point point;
  double arc = 0;
};

/// Returns whether the driver may turn back and forth within a step of arc `length`. It does if it
/// goes forward at both ends, but by Simpson's rule not in the middle.
/// - direction: forward, 1 or −1
bool turns_twice(const SolutionCurve& curve, const SolutionCurve::Point& from,
                 const SolutionCurve::Point& to, double length, double direction);

/// Finds the dead point in a step at whose end the driver goes back. The step must exist. At the
/// dead point the driver's value is stationary: it is known far better than the position. Returns
/// nothing if the value cannot be bracketed to RangeLimits::accuracy.
/// - from, length: start and arc of the step
/// - far: a point before `from`; far.arc leads to `from`
/// - direction: of the driver before the dead point, 1 or −1
std::optional<DeadPoint> find_dead_point(const Model& model, SolutionCurve& curve,
                                         const SolutionCurve::Point& from, const EarlierPoint& far,
                                         double length, double direction);

/// Finds the dead point at which several loops lock at once, just beyond the last point to which a
/// curve can be followed. Curves cross there, and det B vanishes, too. Towards it the driver's
/// speed and singular values of Φ_φ fall like the distance. Returns nothing if they do not, or if
/// the driver's value is not known to the accuracy.
/// - before: a locking_arc before the last point
std::optional<RangeEnd> find_joint_lock(const Model& model, SolutionCurve& curve,
                                        const SolutionCurve::Point& before,
                                        const SolutionCurve::Point& last, double direction);

/// Returns the value at x of Lagrange's polynomial through the points (xs, ys).
double interpolated(std::span<const double> xs, std::span<const double> ys, double x);

/// Returns the driver's value at a crossing of curves in a step. Positions next to a crossing are
/// not well known. So the value at which det B vanishes is interpolated from points further away.
/// If these are not found, it is the middle between `before` and the end of the step, or `before`.
/// - before: an earlier point, from which steps lead to these; its arc leads to the step
/// - length: arc of the step
/// - blocks: number of blocks that become singular. det B vanishes like the distance to this power
double find_crossing(SolutionCurve& curve, const EarlierPoint& before, double length,
                     std::size_t blocks);

}  // namespace desmo
