#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "formulations/verification/range/block_determinants.h"
#include "formulations/verification/range/driver_range.h"
#include "formulations/verification/range/followed_curve.h"
#include "formulations/verification/range/singular_points.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// A sweep of one driver from a start in one direction, until something stops it.
class DriverSweep {
 public:
  using Point = SolutionCurve::Point;

  /// - start: a point of the model's curve for that driver
  /// - direction: of the driver, 1 or −1
  /// The model must outlive the sweep.
  DriverSweep(const Model& m, int driver, const RangeLimits& limits, Point start, double direction);

  /// Sweeps from the start. Returns where it ends, and why.
  RangeEnd run();
  /// Sweeps back on the other branch, which meets this one at the dead point where run() has ended.
  /// Returns nothing if run() ended otherwise, or where several loops lock at once and several
  /// branches meet.
  std::optional<RangeEnd> run_after_dead_point();
  /// Returns the change points of all sweeps, in the order in which they were passed.
  const std::vector<ChangePoint>& change_points() const { return change_points_; }

 private:
  /// The point that a sweep has reached, and the length of its next step.
  struct Progress {
    Point point;
    Determinants determinants;  // of the last point at which none is zero
    double length;              // arc of the next step
    EarlierPoint far;           // last point from which a step longer than a locking_arc was made
    double since = 0;           // arc since the last point at which double roots were looked for
  };
  /// A step that was tried.
  struct Step {
    Point to;
    bool is_across = false;       // starts far away from a crossing, to lead across it
    Determinants determinants{};  // at its end
    bool crosses = false;         // passes a change point
  };
  /// What becomes of a step that is not accepted.
  struct Refusal {
    std::optional<RangeEnd> end{};  // end of the sweep; none: a shorter step is to be tried
  };

  RangeEnd run_from(Point point);
  Progress begin(Point point);
  std::optional<Step> try_step(const Progress& at);
  std::optional<Step> try_step_across(Progress& at);
  bool shorten(Progress& at) const;
  std::optional<Refusal> refuse(Progress& at, Step& step);
  std::optional<Refusal> refuse_turn(Progress& at, const Step& step);
  std::optional<Refusal> refuse_crossing(Progress& at, Step& step);
  std::optional<RangeEnd> accept(Progress& at, Step step);
  Determinants determinants(const Point& p) const { return followed_->determinants.at(p.state); }
  void look_for_double_root(const Point& next, const Determinants& there, double length);
  void look_beyond(const Point& point, const Determinants& here, double length);
  std::optional<RangeEnd> add_crossing(const EarlierPoint& before, double length,
                                       const std::vector<int>& changed);
  double forward(const Point& p) const { return direction_ * p.speed(); }
  bool is_start(const Point& point) const;
  std::optional<RangeEnd> after_turns(const Point& from, const Point& to);
  bool choose_equations(Point& point);
  /// Returns whether two values of the driver are equal to the accuracy.
  bool is_same(double a, double b) const {
    return std::abs(a - b) < limits_.accuracy * curve().scale();
  }
  RangeEnd end(RangeStop stop, const Point& point) const;
  RangeEnd stuck_at(const Point& point, const EarlierPoint& far);

  const Model& model() const { return followed_->model; }
  SolutionCurve& curve() const { return followed_->curve; }
  EntityId driven() const { return model().drivers[driver_].coordinate; }

  const RangeLimits limits_;
  int driver_;  // position in Model::drivers
  std::unique_ptr<FollowedCurve> followed_;
  Point start_;
  double direction_;
  int turns_ = 1;  // number of turns after which the start may be reached again
  std::vector<ChangePoint> change_points_;
  std::optional<Point> turned_;  // point beyond the dead point
};

}  // namespace desmo
