#include "formulations/verification/range/driver_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/scaling/characteristic_lengths.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/range/singular_points.h"
#include "formulations/verification/run/misfit.h"

namespace desmo {

namespace {

constexpr double max_step = 0.1, min_step = 1e-10;  // largest change, scaled
/// A sign that changes in such a step has done so at a crossing, not by a jump across a gap.
constexpr double crossing_step = 1e-6;
constexpr int max_steps = 100'000;  // tried

/// Returns whether a driver is a distance between two points, whose equation holds for its
/// negative, too.
bool is_positive(const Model& m, EntityId driver) {
  const auto is_square = [&](const Constraint& c) {
    return (c.kind == kind_index<Distance<2>>() || c.kind == kind_index<Distance<3>>()) &&
           c.operands.back() == driver;
  };
  return std::ranges::any_of(m.constraints, is_square);
}

}  // namespace

/// Returns the signs of the determinants of all blocks; none where one is singular.
DriverSweep::Signs DriverSweep::signs(const Point& point) {
  if (!determinants_.evaluate(point.state)) return {};
  return {determinants_.signs().begin(), determinants_.signs().end()};
}

std::vector<int> DriverSweep::changed_blocks(const Signs& before, const Signs& after) const {
  std::vector<int> changed;
  for (std::size_t b = 0; b < std::min(before.size(), after.size()); ++b)
    if (before[b] != after[b]) changed.push_back(static_cast<int>(b));
  return changed;
}

/// Returns whether an equation that was left out as dependent does not hold: on another branch, or
/// where the others allow what it forbids.
bool DriverSweep::is_violated(const Point& point) const {
  constexpr double max_misfit = 1e-6;  // over the lengths of its points; more than digits of a file
  const CharacteristicLengths lengths(m_);
  for (int c = 0; c < static_cast<int>(m_.constraints.size()); ++c) {
    const Constraint& constraint = m_.constraints[c];
    if (constraint.left_out == 0) continue;
    std::array<double, 3> phi{};
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      std::array<const double*, Kind::operand_sizes.size()> x;
      for (std::size_t k = 0; k < x.size(); ++k)
        x[k] = point.state.data() + m_.state_index(constraint.operands[k]);
      Kind::residual(x.data(), constraint.constants.data(), phi.data());
    });
    for (int row = 0; row < rows(constraint); ++row) {
      if (!(constraint.left_out >> row & 1)) continue;
      const Misfit misfit = misfit_of(m_, c, row, phi[row], point.state);
      if (misfit.amount > max_misfit * (misfit.is_length ? lengths.of(constraint) : 1)) return true;
    }
  }
  return false;
}

bool DriverSweep::is_start(const Point& point) const {
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
bool DriverSweep::turns_twice(const Point& from, const Point& to, double length) const {
  const double mean =
      direction_ * (curve_.value(to) - curve_.value(from)) / curve_.scale() / length;
  return forward(from) > 0 && forward(to) > 0 &&
         1.5 * mean - (forward(from) + forward(to)) / 4 <= 0;
}

RangeEnd DriverSweep::end(RangeStop stop, const Point& point) const {
  const double value = curve_.value(point);
  return {.stop = stop, .value = value, .beyond = value};
}

/// Looks whether a step passes a whole turn, and whether that is the start again.
std::optional<RangeEnd> DriverSweep::after_turns(const Point& from, const Point& to) {
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

/// Looks for a double root around the last point. What lies before the start is of the sweep in
/// the other direction.
void DriverSweep::look_for_double_root(const Point& next, double length) {
  if (const std::optional<DoubleRoot> root = double_roots_.add(next, length))
    if (direction_ * (root->value - curve_.value(start_)) > -same * curve_.scale() &&
        (change_points_.empty() ||
         std::abs(change_points_.back().value - root->value) > same * curve_.scale()))
      change_points_.push_back({root->value, root->group, true});
}

RangeEnd DriverSweep::run_from(Point point) {
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
          {value, changed.empty() ? no_position : determinants_.group(changed.front())});
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

}  // namespace desmo
