#include "formulations/verification/range/driver_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/misfit.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/independence/linearisation.h"
#include "formulations/verification/branch/chosen_equations.h"
#include "formulations/verification/range/singular_points.h"

namespace desmo {

namespace {

/// Returns whether a driver is the distance of two points. Its equation is quadratic, so that it
/// holds for negative values, too, which mean nothing.
bool is_positive(const Model& m, EntityId driver) {
  const auto is_square = [&](const Constraint& c) {
    return (c.kind == kind_index<Distance<2>>() || c.kind == kind_index<Distance<3>>()) &&
           c.operands.back() == driver;
  };
  return std::ranges::any_of(m.constraints, is_square);
}

}  // namespace

DriverSweep::DriverSweep(const Model& m, int driver, const RangeLimits& limits, Point start,
                         double direction)
    : limits_(limits),
      driver_(driver),
      followed_(std::make_unique<Followed>(m, driver, limits)),
      start_(std::move(start)),
      direction_(direction) {}

/// Takes other equations of overconstrained groups if the kept ones become dependent and others are
/// better (with_chosen_equations()). Returns whether it does: the point is then on their curve.
bool DriverSweep::choose_equations(Point& point) {
  auto chosen = with_chosen_equations(
      model(), std::span(point.state).first(static_cast<std::size_t>(model().coordinates())));
  if (!chosen) return false;
  auto other = std::make_unique<Followed>(*chosen, driver_, limits_);
  other->own = std::move(chosen);
  if (other->curve.unknowns() != curve().unknowns()) return false;
  std::optional<Point> same_point = other->curve.at(point, curve().value(point));
  if (!same_point) return false;
  followed_ = std::move(other);
  point = *std::move(same_point);
  return true;
}

/// Returns whether the misfit of a left-out equation over its length exceeds max_misfit. The point
/// is then on another branch, or the kept equations allow what the left-out one forbids.
bool DriverSweep::is_violated(const Point& point) const {
  const CharacteristicLengths lengths(model());
  for (int c = 0; c < static_cast<int>(model().constraints.size()); ++c) {
    const Constraint& constraint = model().constraints[c];
    if (constraint.left_out == 0) continue;
    const std::vector<double> phi = residual_of(model(), constraint, point.state);
    for (int row = 0; row < rows(constraint); ++row) {
      if (!(constraint.left_out >> row & 1)) continue;
      const Misfit misfit = misfit_of(model(), c, row, phi[row], point.state);
      if (misfit.over(lengths.of(constraint)) > max_misfit) return true;
    }
  }
  return false;
}

bool DriverSweep::is_start(const Point& point) const {
  const std::vector<EntityId> owner = entity_of_coordinate(model());
  for (std::size_t j = 0; j < curve().unknowns().size(); ++j) {
    const int i = curve().unknowns()[j];
    double change = point.state[i] - start_.state[i];
    if (model().entities[owner[i]].kind == EntityKind::angle)
      change = std::remainder(change, 2 * std::numbers::pi);
    if (!(std::abs(change) <= limits_.accuracy * curve().scale(static_cast<int>(j)))) return false;
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
  const double far =
      turns ? 2 * std::numbers::pi * turns_ : 10 * nominal_magnitudes(model())[driver.first];
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
  if (is_positive(model(), driven()) && is_same(value, 0))
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
  double length = limits_.max_step;
  followed_->double_roots.restart();
  Determinants before = determinants(point);
  look_beyond(point, before, -length);
  if (!before.empty()) look_for_double_root(point, before, length);
  double since = 0;         // arc since the last point that double roots were looked for at
  EarlierPoint far{point};  // the last point from which a step longer than a locking_arc was made
  for (int step = 0; step < limits_.max_steps; ++step) {
    const auto again = [&] { return (length /= 2) > limits_.accuracy; };
    std::optional<Point> next = curve().step(point, length);
    if (!next && again()) continue;
    // So near to a crossing, rounding may turn a step back. A step from further away leads across.
    bool is_across = false;
    if (length <= limits_.max_crossing_step && (!next || forward(*next) <= 0)) {
      std::optional<Point> across = curve().step(far.point, far.arc + limits_.max_crossing_step);
      is_across = across && forward(*across) > 0;
      if (is_across) {
        next = std::move(across);
        length = far.arc + limits_.max_crossing_step;
        point = std::exchange(far, {far.point, 0}).point;
      }
    }
    if (!next) return stuck_at(point, far);
    const bool turns = forward(*next) <= 0;
    // det B keeps its sign at a dead point. A step across a gap between branches changes it.
    if (turns && next->sign == point.sign)
      if (auto dead = find_dead_point(model(), curve(), point, far, length, direction_)) {
        turned_ = std::move(dead->after);
        return std::move(dead->end);
      }
    if (turns || turns_twice(curve(), point, *next, length, direction_)) {
      if (again()) continue;
      return stuck_at(point, far);
    }
    const Determinants after = determinants(*next);
    const std::vector<int> changed = before.changed(after);
    const bool crosses = next->sign != point.sign || !changed.empty();
    if (crosses) {
      if (length > limits_.max_crossing_step && !is_across) {
        length /= 2;
        continue;
      }
      if (std::optional<RangeEnd> zero = add_crossing(far, length, changed))
        return *std::move(zero);
    }
    if (is_violated(*next)) {
      if (again()) continue;
      return end(RangeStop::other_branch, point);
    }
    since += length;
    if (crosses) followed_->double_roots.restart();
    if (!after.empty() && !crosses) look_for_double_root(*next, after, std::exchange(since, 0));
    if (std::optional<RangeEnd> turned = after_turns(point, *next)) {
      look_beyond(*next, after, length);
      return *std::move(turned);
    }
    if (!after.empty()) before = after;
    if (length > limits_.locking_arc()) far = {point, 0};
    far.arc += length;
    point = *std::move(next);
    if (choose_equations(point)) {
      before = determinants(point);
      followed_->double_roots.restart();
    }
    length = crosses ? limits_.max_step : std::min(limits_.max_step, 2 * length);
  }
  return end(RangeStop::not_reached, point);
}

}  // namespace desmo
