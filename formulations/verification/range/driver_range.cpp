#include "formulations/verification/range/driver_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/scaled_system.h"
#include "formulations/verification/monitor/branch_monitor.h"
#include "formulations/verification/range/double_roots.h"
#include "formulations/verification/range/singular_points.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

namespace {

using Point = SolutionCurve::Point;
using Signs = std::vector<signed char>;

constexpr double max_step = 0.1, min_step = 1e-10;  // largest change, scaled
/// A sign that changes in such a step has done so at a crossing, not by a jump across a gap.
constexpr double crossing_step = 1e-6;
constexpr int max_steps = 100'000;  // tried
constexpr double accuracy = 1e-9;   // scaled
constexpr double same = 1e-7;       // of two positions, scaled

/// Returns whether a driver is a distance between two points, whose equation holds for its
/// negative, too.
bool is_positive(const Model& m, EntityId driver) {
  const auto is_square = [&](const Constraint& c) {
    return (c.kind == kind_index<Distance<2>>() || c.kind == kind_index<Distance<3>>()) &&
           c.operands.back() == driver;
  };
  return std::ranges::any_of(m.constraints, is_square);
}

/// The way from a start in one direction.
class Way {
 public:
  Way(const Model& m, SolutionCurve& curve, int driver, const Point& start, double direction)
      : m_(m),
        curve_(curve),
        system_(m),
        monitor_(m, {}, 1e-12),
        double_roots_(curve, system_),
        driver_(m.drivers[driver].coordinate),
        start_(start),
        direction_(direction) {}

  RangeEnd go() { return go_from(direction_ > 0 ? start_ : SolutionCurve::reversed(start_)); }
  /// Goes on after a dead point on the branch that meets this one there.
  RangeEnd go_back() {
    direction_ = -direction_;
    return go_from(*std::move(turned_));
  }
  const std::vector<ChangePoint>& change_points() const { return change_points_; }

 private:
  RangeEnd go_from(Point point);
  Signs signs(const Point& point);
  void look_for_double_root(const Point& next, double length);
  std::vector<int> changed_blocks(const Signs& before, const Signs& after) const;
  double forward(const Point& p) const { return direction_ * p.speed(); }
  bool is_violated(const Point& point);
  bool is_start(const Point& point) const;
  bool turns_twice(const Point& from, const Point& to, double length) const;
  std::optional<RangeEnd> after_turns(const Point& from, const Point& to);
  RangeEnd end(RangeStop stop, const Point& point) const;

  const Model& m_;
  SolutionCurve& curve_;
  ScaledSystem system_;
  BranchMonitor monitor_;
  DoubleRootSearch double_roots_;
  EntityId driver_;
  const Point& start_;
  double direction_;
  int turns_ = 1;  // after which it is looked for the start
  std::vector<ChangePoint> change_points_;
  std::optional<Point> turned_;  // after the dead point
};

/// Returns the signs of the determinants of all blocks; none where one is singular.
Signs Way::signs(const Point& point) {
  if (!system_.factor(point.state)) return {};
  return {system_.orientation().begin(), system_.orientation().end()};
}

std::vector<int> Way::changed_blocks(const Signs& before, const Signs& after) const {
  std::vector<int> changed;
  for (std::size_t b = 0; b < std::min(before.size(), after.size()); ++b)
    if (before[b] != after[b]) changed.push_back(static_cast<int>(b));
  return changed;
}

bool Way::is_violated(const Point& point) {
  const std::span<const double> state = point.state;
  return monitor_.violated({0, 0, state.first(m_.coordinates()), {}, {}}) >= 0;
}

bool Way::is_start(const Point& point) const {
  const std::vector<EntityId> owner = entity_of_coordinate(m_);
  for (std::size_t j = 0; j < curve_.unknowns().size(); ++j) {
    const int i = curve_.unknowns()[j];
    double change = point.state[i] - start_.state[i];
    if (m_.entities[owner[i]].kind == EntityKind::angle)
      change = std::remainder(change, 2 * std::numbers::pi);
    if (!(std::abs(change) <= same * curve_.scale(static_cast<int>(j)))) return false;
  }
  return true;
}

/// Returns whether the driver may have turned back and forth within a step: its speed in the
/// middle, by Simpson's rule, is not forward.
bool Way::turns_twice(const Point& from, const Point& to, double length) const {
  const double mean =
      direction_ * (curve_.value(to) - curve_.value(from)) / curve_.scale() / length;
  return forward(from) > 0 && forward(to) > 0 &&
         1.5 * mean - (forward(from) + forward(to)) / 4 <= 0;
}

RangeEnd Way::end(RangeStop stop, const Point& point) const {
  const double value = curve_.value(point);
  return {.stop = stop, .value = value, .beyond = value};
}

/// Looks whether a step passes a whole turn, and whether that is the start again.
std::optional<RangeEnd> Way::after_turns(const Point& from, const Point& to) {
  const Entity& driver = m_.entities[driver_];
  const bool turns = driver.kind == EntityKind::angle;
  const double far =
      turns ? 2 * std::numbers::pi * turns_ : 10 * natural_magnitudes(m_)[driver.first];
  const double target = curve_.value(start_) + direction_ * far;
  if (direction_ * (curve_.value(to) - target) < 0) return {};
  if (!turns) return end(RangeStop::none, to);
  std::optional<Point> there = curve_.at(to, target);
  if (!there) there = curve_.at(from, target);
  if (there && is_start(*there)) {
    RangeEnd e = end(RangeStop::full_turn, *there);
    e.turns = turns_;
    return e;
  }
  if (turns_ == 2) return end(RangeStop::none, to);
  turns_ = 2;
  return {};
}

/// Looks for a double root around the last point. What lies before the start is of the way in the
/// other direction.
void Way::look_for_double_root(const Point& next, double length) {
  if (const std::optional<DoubleRoot> root = double_roots_.add(next, length))
    if (direction_ * (root->value - curve_.value(start_)) > -same * curve_.scale() &&
        (change_points_.empty() ||
         std::abs(change_points_.back().value - root->value) > same * curve_.scale()))
      change_points_.push_back({root->value, root->group, true});
}

RangeEnd Way::go_from(Point point) {
  is_violated(start_);  // the declared position; angles are followed from it
  double length = max_step / 8;
  double_roots_.restart();
  Signs before = signs(point);
  const std::optional<Point> behind = curve_.step(point, -length);
  if (!before.empty() && behind && behind->sign == point.sign && signs(*behind) == before)
    look_for_double_root(*behind, length);
  if (before = signs(point); !before.empty()) look_for_double_root(point, length);
  double since = 0;  // the last point that was looked at
  for (int step = 0; step < max_steps; ++step) {
    const auto again = [&] { return (length /= 2) > min_step; };
    std::optional<Point> next = curve_.step(point, length);
    if (!next) {
      if (again()) continue;
      return end(RangeStop::not_reached, point);
    }
    if (forward(*next) <= 0) {
      // Signs of B do not change at a dead point: a step across a gap is not one.
      if (next->sign == point.sign)
        if (auto dead = find_dead_point(m_, curve_, point, length, direction_, accuracy)) {
          turned_ = std::move(dead->after);
          return std::move(dead->end);
        }
      if (again()) continue;
      return end(RangeStop::not_reached, point);
    }
    if (turns_twice(point, *next, length) && again()) continue;
    const Signs after = signs(*next);
    const std::vector<int> changed = changed_blocks(before, after);
    const bool crosses = next->sign != point.sign || !changed.empty();
    if (crosses) {
      if (length > crossing_step) {
        length /= 2;
        continue;
      }
      const double value = find_crossing(curve_, point, *next, changed.size());
      if (is_positive(m_, driver_) && std::abs(value) < same * curve_.scale())
        return {.stop = RangeStop::zero_length};
      change_points_.push_back(
          {value, changed.empty() ? -1 : system_.group_of_block(changed.front())});
    }
    if (is_violated(*next)) {
      if (again()) continue;
      return end(RangeStop::other_branch, point);
    }
    since += length;
    if (crosses) double_roots_.restart();
    if (!after.empty() && !crosses) look_for_double_root(*next, std::exchange(since, 0));
    if (std::optional<RangeEnd> turned = after_turns(point, *next)) {
      if (const std::optional<Point> p = curve_.step(*next, length); p && signs(*p) == after)
        look_for_double_root(*p, length);
      return *std::move(turned);
    }
    if (!after.empty()) before = after;
    point = *std::move(next);
    length = crosses ? max_step / 64 : std::min(max_step, 1.5 * length);
  }
  return end(RangeStop::not_reached, point);
}

}  // namespace

DriverRange find_range(const Model& m, std::span<const double> q, int driver) {
  std::vector<double> state(q.begin(), q.end());
  state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
  SolutionCurve curve(m, driver);
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

  std::optional<Point> start = curve.start(std::move(state));
  if (curve.is_crossing()) {
    range.down.stop = range.up.stop = RangeStop::start;
    return range;
  }
  // At a dead point the driver has no direction: a little further it has.
  constexpr double stationary = 1e-9, beside = 1e-6;
  if (start && std::abs(start->speed()) < stationary) {
    start = curve.step(*start, beside);
    if (start && start->speed() < 0) start = SolutionCurve::reversed(*std::move(start));
  }
  require(start && std::abs(curve.value(*start) - range.start) <= accuracy * curve.scale(),
          "no position was found");

  Way up(m, curve, driver, *start, 1), down(m, curve, driver, *start, -1);
  range.up = up.go();
  if (range.up.stop == RangeStop::full_turn) {
    range.down = range.up;
    range.down.value = range.down.beyond = 2 * range.start - range.up.value;
  } else {
    range.down = down.go();
  }
  for (const auto& [way, end] : {std::pair(&up, &range.up), std::pair(&down, &range.down)})
    if (end->stop == RangeStop::dead_point &&
        std::abs(end->value - range.start) < accuracy * curve.scale())
      range.other_branch = way->go_back();
  for (const Way* way : {&down, &up})
    range.change_points.insert(range.change_points.end(), way->change_points().begin(),
                               way->change_points().end());
  std::ranges::sort(range.change_points, {}, &ChangePoint::value);
  // A double root next to an end of a turn is found at both.
  const auto is_double = [&](const ChangePoint& c, double value) {
    return c.is_double && std::abs(c.value - value) < same * curve.scale();
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
