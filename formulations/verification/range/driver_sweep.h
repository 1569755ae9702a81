#pragma once

#include <optional>
#include <vector>

#include "formulations/verification/range/block_determinants.h"
#include "formulations/verification/range/double_roots.h"
#include "formulations/verification/range/driver_range.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// A sweep of one driver from a start in one direction, until something stops it.
class DriverSweep {
 public:
  using Point = SolutionCurve::Point;
  static constexpr double accuracy = 1e-9;  ///< of values, scaled
  static constexpr double same = 1e-7;      ///< of two positions, scaled

  DriverSweep(const Model& m, SolutionCurve& curve, int driver, const Point& start,
              double direction)
      : m_(m),
        curve_(curve),
        determinants_(m),
        double_roots_(curve, determinants_),
        driver_(m.drivers[driver].coordinate),
        start_(start),
        direction_(direction) {}

  /// Sweeps from the start. Returns where it ends, and why.
  RangeEnd run() { return run_from(direction_ > 0 ? start_ : SolutionCurve::reversed(start_)); }
  /// Sweeps back on the other branch, which meets this one at the dead point where run() has ended.
  RangeEnd run_after_dead_point() {
    direction_ = -direction_;
    return run_from(*std::move(turned_));
  }
  /// Returns the change points of all sweeps, in the order in which they were passed.
  const std::vector<ChangePoint>& change_points() const { return change_points_; }

 private:
  using Signs = std::vector<signed char>;

  RangeEnd run_from(Point point);
  Signs signs(const Point& point);
  void look_for_double_root(const Point& next, double length);
  std::vector<int> changed_blocks(const Signs& before, const Signs& after) const;
  double forward(const Point& p) const { return direction_ * p.speed(); }
  bool is_violated(const Point& point) const;
  bool is_start(const Point& point) const;
  bool turns_twice(const Point& from, const Point& to, double length) const;
  std::optional<RangeEnd> after_turns(const Point& from, const Point& to);
  RangeEnd end(RangeStop stop, const Point& point) const;

  const Model& m_;
  SolutionCurve& curve_;
  BlockDeterminants determinants_;
  DoubleRootSearch double_roots_;
  EntityId driver_;
  const Point& start_;
  double direction_;
  int turns_ = 1;  // after which it is looked for the start
  std::vector<ChangePoint> change_points_;
  std::optional<Point> turned_;  // after the dead point
};

}  // namespace desmo
