#include "formulations/verification/range/driver_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "formulations/verification/branch/chosen_equations.h"
#include "formulations/verification/range/singular_points.h"

namespace desmo {

DriverSweep::DriverSweep(const Model& m, int driver, const RangeLimits& limits, Point start,
                         double direction)
    : limits_(limits),
      driver_(driver),
      followed_(std::make_unique<FollowedCurve>(m, driver, limits)),
      start_(std::move(start)),
      direction_(direction) {}

/// Takes other equations of overconstrained groups if the kept ones become dependent and others are
/// better (with_chosen_equations()). Returns whether it does: the point is then on their curve.
bool DriverSweep::choose_equations(Point& point) {
  auto chosen = with_chosen_equations(
      model(), std::span(point.state).first(static_cast<std::size_t>(model().coordinates())));
  if (!chosen) return false;
  auto other = std::make_unique<FollowedCurve>(std::move(chosen), driver_, limits_);
  if (other->curve.unknowns() != curve().unknowns()) return false;
  std::optional<Point> same_point = other->curve.at(point, curve().value(point));
  if (!same_point) return false;
  followed_ = std::move(other);
  point = *std::move(same_point);
  return true;
}

/// Returns whether a point is the start, to the accuracy and to what the driver's rounding moves.
bool DriverSweep::is_start(const Point& point) const {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double rounding = epsilon * std::abs(curve().value(point)) / curve().scale();
  const std::vector<EntityId> owner = entity_of_coordinate(model());
  for (std::size_t j = 0; j < curve().unknowns().size(); ++j) {
    const int i = curve().unknowns()[j];
    double change = point.state[i] - start_.state[i];
    if (model().entities[owner[i]].kind == EntityKind::angle)
      change = std::remainder(change, 2 * std::numbers::pi);
    const double moved = rounding * std::abs(point.tangent[static_cast<int>(j)] / point.speed());
    const double max_change = (limits_.accuracy + moved) * curve().scale(static_cast<int>(j));
    if (!(std::abs(change) <= max_change + epsilon * std::abs(point.state[i]))) return false;
  }
  return true;
}

RangeEnd DriverSweep::end(RangeStop stop, const Point& point) const {
  const double value = curve().value(point);
  return {.stop = stop, .value = value, .beyond = value};
}

/// Returns the end of a sweep that goes no further than a point: a lock of several loops at once,
/// or RangeStop::not_reached.
RangeEnd DriverSweep::stuck_at(const Point& point, const EarlierPoint& far) {
  if (const std::optional<Point> before = curve().step(far.point, far.arc - limits_.locking_arc()))
    if (auto lock = find_joint_lock(model(), curve(), *before, point, direction_))
      return *std::move(lock);
  return end(RangeStop::not_reached, point);
}

/// Returns the end if a step passes a whole turn that leads to the start again, or the second turn.
/// A driver that is no angle ends where it passes ten times its nominal magnitude.
std::optional<RangeEnd> DriverSweep::after_turns(const Point& from, const Point& to) {
  const Entity& driver = model().entities[driven()];
  const bool turns = driver.kind == EntityKind::angle;
  const double far = turns ? 2 * std::numbers::pi * turns_ : 10 * followed_->driver_magnitude;
  const double target = curve().value(start_) + direction_ * far;
  if (direction_ * (curve().value(to) - target) < 0) return {};
  if (!turns) return end(RangeStop::none, to);
  std::optional<Point> there = curve().at(to, target);
  if (!there) there = curve().at(from, target);
  if (there && is_start(*there)) {
    RangeEnd e = end(RangeStop::full_turn, *there);
    e.turns = turns_;
    return e;
  }
  if (turns_ == 2) return end(RangeStop::none, to);
  turns_ = 2;
  return {};
}

/// Looks for a double root near the last point. Roots before the start belong to the sweep in the
/// other direction.
void DriverSweep::look_for_double_root(const Point& next, const Determinants& there,
                                       double length) {
  if (const std::optional<ChangePoint> root = followed_->double_roots.add(next, there, length))
    if (direction_ * (root->value - curve().value(start_)) > -limits_.accuracy * curve().scale() &&
        (change_points_.empty() || !is_same(change_points_.back().value, root->value)))
      change_points_.push_back(*root);
}

/// Looks for a double root up to one more point, unless a determinant changes its sign before that.
void DriverSweep::look_beyond(const Point& point, const Determinants& here, double length) {
  if (here.empty()) return;
  const std::optional<Point> next = curve().step(point, length);
  if (!next || next->sign != point.sign) return;
  if (const Determinants there = determinants(*next); there.signs == here.signs)
    look_for_double_root(*next, there, std::abs(length));
}

/// Adds the change point at a crossing in a step. If a driven distance is zero there, returns that
/// end instead.
std::optional<RangeEnd> DriverSweep::add_crossing(const EarlierPoint& before, double length,
                                                  const std::vector<int>& changed) {
  const double value = find_crossing(curve(), before, length, changed.size());
  if (followed_->is_driver_positive && is_same(value, 0))
    return RangeEnd{.stop = RangeStop::zero_length};
  change_points_.push_back(
      {value, changed.empty() ? no_position : followed_->determinants.group(changed.front())});
  return {};
}

RangeEnd DriverSweep::run() {
  return run_from(direction_ > 0 ? start_ : SolutionCurve::reversed(start_));
}

std::optional<RangeEnd> DriverSweep::run_after_dead_point() {
  if (!turned_) return {};
  direction_ = -direction_;
  return run_from(*std::move(turned_));
}

RangeEnd DriverSweep::run_from(Point point) {
  Progress at = begin(std::move(point));
  for (int tried = 0; tried < limits_.max_steps; ++tried) {
    std::optional<Step> step = try_step(at);
    if (!step && shorten(at)) continue;
    // So near to a crossing, rounding may turn a step back. A step from further away leads across.
    if (at.length <= limits_.max_crossing_step && (!step || forward(step->to) <= 0))
      if (std::optional<Step> across = try_step_across(at)) step = std::move(across);
    if (!step) return stuck_at(at.point, at.far);
    if (std::optional<Refusal> refusal = refuse(at, *step)) {
      if (refusal->end) return *std::move(refusal->end);
      continue;
    }
    if (std::optional<RangeEnd> end = accept(at, *std::move(step))) return *std::move(end);
  }
  return end(RangeStop::not_reached, at.point);
}

/// Begins a sweep at a point. Looks for a double root there.
DriverSweep::Progress DriverSweep::begin(Point point) {
  const double length = limits_.max_step;
  followed_->double_roots.restart();
  Determinants here = determinants(point);
  look_beyond(point, here, -length);
  if (!here.empty()) look_for_double_root(point, here, length);
  EarlierPoint far{point};
  return {std::move(point), std::move(here), length, std::move(far)};
}

std::optional<DriverSweep::Step> DriverSweep::try_step(const Progress& at) {
  std::optional<Point> to = curve().step(at.point, at.length);
  if (!to) return {};
  return Step{*std::move(to)};
}

/// Tries a step from the far point across a crossing. If it leads forward, goes back to the far
/// point, where it starts.
std::optional<DriverSweep::Step> DriverSweep::try_step_across(Progress& at) {
  const double length = at.far.arc + limits_.max_crossing_step;
  std::optional<Point> to = curve().step(at.far.point, length);
  if (!to || !(forward(*to) > 0)) return {};
  at.length = length;
  at.point = at.far.point;
  at.far.arc = 0;
  return Step{.to = *std::move(to), .is_across = true};
}

/// Halves the next step. Returns whether it is still longer than the accuracy.
bool DriverSweep::shorten(Progress& at) const {
  at.length /= 2;
  return at.length > limits_.accuracy;
}

/// Returns why a step is not accepted: the driver turns back in it, it is too long for a crossing
/// or ends at one, or it leads to another branch. Returns nothing if it is accepted.
std::optional<DriverSweep::Refusal> DriverSweep::refuse(Progress& at, Step& step) {
  if (std::optional<Refusal> turn = refuse_turn(at, step)) return turn;
  if (std::optional<Refusal> crossing = refuse_crossing(at, step)) return crossing;
  if (!followed_->is_violated(step.to)) return {};
  if (shorten(at)) return Refusal{};
  return Refusal{end(RangeStop::other_branch, at.point)};
}

/// Refuses a step in which the driver turns back. The sweep ends at a dead point.
std::optional<DriverSweep::Refusal> DriverSweep::refuse_turn(Progress& at, const Step& step) {
  const bool turns = forward(step.to) <= 0;
  // det B keeps its sign at a dead point. A step across a gap between branches changes it.
  if (turns && step.to.sign == at.point.sign)
    if (auto dead = find_dead_point(model(), curve(), at.point, at.far, at.length, direction_)) {
      turned_ = std::move(dead->after);
      return Refusal{std::move(dead->end)};
    }
  if (!turns && !turns_twice(curve(), at.point, step.to, at.length, direction_)) return {};
  if (shorten(at)) return Refusal{};
  return Refusal{stuck_at(at.point, at.far)};
}

/// Finds out whether a step crosses another branch, and adds the change point. Refuses the step if
/// it is too long for that, or if a driven distance is zero there.
std::optional<DriverSweep::Refusal> DriverSweep::refuse_crossing(Progress& at, Step& step) {
  step.determinants = determinants(step.to);
  const std::vector<int> changed = at.determinants.changed(step.determinants);
  const bool passes_zero =
      followed_->is_driver_positive && curve().value(start_) * curve().value(step.to) < 0;
  step.crosses = step.to.sign != at.point.sign || !changed.empty() || passes_zero;
  if (!step.crosses) return {};
  if (at.length > limits_.max_crossing_step && !step.is_across) {
    at.length /= 2;
    return Refusal{};
  }
  if (passes_zero) return Refusal{RangeEnd{.stop = RangeStop::zero_length}};
  if (std::optional<RangeEnd> zero = add_crossing(at.far, at.length, changed))
    return Refusal{std::move(zero)};
  return {};
}

/// Goes to the end of a step. Returns the end of the sweep if the driver has turned far enough.
std::optional<RangeEnd> DriverSweep::accept(Progress& at, Step step) {
  const bool is_regular = !step.determinants.empty();
  at.since += at.length;
  if (step.crosses) followed_->double_roots.restart();
  if (is_regular && !step.crosses)
    look_for_double_root(step.to, step.determinants, std::exchange(at.since, 0));
  if (std::optional<RangeEnd> turned = after_turns(at.point, step.to)) {
    look_beyond(step.to, step.determinants, at.length);
    return turned;
  }
  if (is_regular) at.determinants = std::move(step.determinants);
  if (at.length > limits_.locking_arc()) at.far = {std::move(at.point), 0};
  at.far.arc += at.length;
  at.point = std::move(step.to);
  if (choose_equations(at.point)) {
    at.determinants = determinants(at.point);
    followed_->double_roots.restart();
  }
  at.length = step.crosses ? limits_.max_step : std::min(limits_.max_step, 2 * at.length);
  return {};
}

}  // namespace desmo
