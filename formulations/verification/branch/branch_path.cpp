#include "formulations/verification/branch/branch_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/numbers/interval.h"
#include "formulations/verification/branch/step_growth.h"

namespace desmo {

namespace {

constexpr double above = 1 + 0x1p-50;  // covers the few roundings of a comparison

/// Returns whether the certified boxes of two instants are disjoint, so that their solutions
/// differ.
bool are_apart(const CertifiedInstant& a, const CertifiedInstant& b) {
  for (std::size_t i = 0; i < a.radius.size(); ++i) {
    const double distance = std::abs(a.values.position[i] - b.values.position[i]);
    if (distance > (a.radius[i] + b.radius[i]) * above) return true;
  }
  return false;
}

}  // namespace

BranchPath::BranchPath(const Model& m, int budget)
    : m_(m),
      budget_(budget),
      refinement_(m),
      path_(m, refinement_.certifier()),
      memory_(m.coordinates()),
      predicted_(m.coordinates()) {}

/// Makes a proven instant the present one.
void BranchPath::keep(const RefinedInstant& r) {
  memory_.assign(certified(r));
  present_ = memory_.view();
  worst_conditioned_ = r.last.worst_conditioned;
}

/// Missing rates are found from zeros: their equations are linear, so that corrections lead to the
/// solution from anywhere.
bool BranchPath::start_at(const CertifiedInstant& instant) {
  bool complete = true;
  for (const Level level : all_levels) {
    const std::span<const double> given = instant.values[level];
    for (int i = 0; i < m_.coordinates(); ++i) {
      const bool solved = !given.empty() && (instant.levels.empty() || level <= instant.levels[i]);
      predicted_.values[level][i] = solved ? given[i] : 0;
      complete &= solved;
    }
  }
  if (complete) {
    predicted_.time = instant.time;
    std::ranges::copy(instant.radius, predicted_.radius.begin());
    std::swap(memory_, predicted_);
    present_ = memory_.view();
    worst_conditioned_ = no_position;
    return true;
  }
  const RefinedInstant& refined =
      refinement_.refine(instant_of(instant.time, predicted_.view().values));
  if (refined.proven) keep(refined);
  return refined.proven;
}

/// Finds the solution at a time by corrections from Taylor's polynomial about the present instant.
const RefinedInstant& BranchPath::predict(double time) {
  const double h = time - present_.time;
  const auto& [q, qd, qdd] = memory_.values;
  for (int i = 0; i < m_.coordinates(); ++i) {
    predicted_.values.position[i] = q[i] + h * (qd[i] + h / 2 * qdd[i]);
    predicted_.values.velocity[i] = qd[i] + h * qdd[i];
    predicted_.values.acceleration[i] = qdd[i];
  }
  for (const Driver& d : m_.drivers) {
    const int i = m_.entities[d.coordinate].first;
    const MotionSample<double> z = sample(d.motion, time);
    predicted_.values.position[i] = z.position;
    predicted_.values.velocity[i] = z.velocity;
    predicted_.values.acceleration[i] = z.acceleration;
  }
  return refinement_.refine(instant_of(time, predicted_.view().values));
}

/// Tests the step from the present instant to another one, earlier or later. Returns whether it is
/// proven, and accepted (ask_about_steps()). Adds the test to the report, with the group that
/// fails.
bool BranchPath::proves(const CertifiedInstant& to, FollowedStep& report) {
  ++report.tests;
  const PathCertificate c =
      to.time < present_.time ? path_.prove(to, present_) : path_.prove(present_, to);
  report.group = c.group;
  return c.proven && (!is_accepted_ || is_accepted_(path_));
}

/// Returns `time`, or the first knot on the way there from the present time.
double BranchPath::up_to_knot(double time) const {
  while (const std::optional<double> knot =
             first_knot(m_, std::min(time, present_.time), std::max(time, present_.time)))
    time = *knot;
  return time;
}

bool BranchPath::contains(double time, std::span<const double> q,
                          std::span<const double> tolerances, double count) const {
  for (int i = 0; i < m_.coordinates(); ++i) {
    const double slack = count * tolerances[i];
    if (!(std::abs(q[i] - path_.centre(i, time)) <= path_.radius(i) + slack)) return false;
  }
  return true;
}

FollowedStep BranchPath::follow(const CertifiedInstant& to) { return go(to.time, &to, budget_); }

FollowedStep BranchPath::go_to(double time) { return go(time, nullptr, budget_); }

FollowedStep BranchPath::go_to(double time, TestBudget& budget) {
  const FollowedStep step = go(time, nullptr, std::min(budget_, budget.half().left()));
  budget.take(std::max(1, step.tests));
  return step;
}

/// Goes to a time. to: the instant there; null: none. Each turn of the loop costs a test of the
/// budget or halves the step, so it ends.
FollowedStep BranchPath::go(double time, const CertifiedInstant* to, int budget) {
  FollowedStep result;
  const auto ended = [&](PathEnd end) {
    result.end = end;
    result.time = present_.time;
    return result;
  };
  if (time == present_.time)
    return ended(to && are_apart(*to, present_) ? PathEnd::other : PathEnd::same);
  double step = time - present_.time;
  const double shortest = std::abs(step) * Interval::unit;
  StepGrowth growth;
  bool tries_whole = to != nullptr;  // the step straight to the instant is not tested yet
  while (result.tests < budget && std::abs(step) > shortest &&
         present_.time + step != present_.time) {
    const double left = time - present_.time;
    const double next = up_to_knot(std::abs(step) < std::abs(left) ? present_.time + step : time);
    if (next == time && to) {
      if (proves(*to, result)) {
        ++result.sub_steps;
        // start_at() proves rates that the instant lacks. Rounding may prevent that: the step then
        // counts as stuck where it began.
        return ended(start_at(*to) ? PathEnd::same : PathEnd::stuck);
      }
      if (tries_whole) {
        tries_whole = false;
        step /= 2;
        continue;
      }
    }
    const RefinedInstant& found = predict(next);
    result.group = found.last.group;
    const bool proven = found.proven && proves(certified(found), result);
    // No step to the instant is proven, but the solution found at its time may be the same one.
    // Shorter sub-steps tell.
    if (!proven || (next == time && to && !are_apart(*to, certified(found)))) {
      growth.failed();
      step = (next - present_.time) / 2;
      if (present_.time + step == next) break;  // there is no time between the two
      continue;
    }
    ++result.sub_steps;
    keep(found);
    if (next == time) return ended(to ? PathEnd::other : PathEnd::same);
    if (growth.succeeded()) step *= 2;
  }
  result.out_of_tests = result.tests >= budget;
  // The worst-conditioned group may spoil proofs of later ones, and is then named.
  if (worst_conditioned_ != no_position) result.group = std::min(result.group, worst_conditioned_);
  return ended(PathEnd::stuck);
}

}  // namespace desmo
