#include "formulations/verification/monitor/branch_monitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "formulations/constraints/constraints.h"
#include "formulations/scaling/magnitudes.h"

namespace desmo {

namespace {

/// Limits of an equation's error relative to the sum of its terms: more than rounding, or a coarse
/// tolerance times `per_tolerance`, leaves, and less than another branch does.
constexpr double min_allowed = 1e-6, per_tolerance = 1e3, max_allowed = 0.1;

bool is_solved_to(const Model& m, std::span<const Level> solved, const Constraint& constraint,
                  Level level) {
  return solved.empty() || std::ranges::all_of(constraint.operands, [&](EntityId id) {
           return m.entities[id].fixed || solved[m.entities[id].first] >= level;
         });
}

}  // namespace

BranchMonitor::BranchMonitor(const Model& m, std::span<const Level> levels, double tolerance)
    : model_(m),
      allowed_(std::clamp(per_tolerance * tolerance, min_allowed, max_allowed)),
      last_(m.estimate) {
  const std::vector<bool> driven = independent_coordinates(m);
  const Magnitudes magnitudes(m);
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c) {
    const Constraint& constraint = m.constraints[c];
    bool modulo_pi = false;
    visit_kind(constraint.kind, [&]<class Kind>(Kind) { modulo_pi = holds_modulo_pi<Kind>; });
    if (!modulo_pi && constraint.left_out == 0) continue;
    Check check{c, is_solved_to(m, levels, constraint, Level::velocity)};
    for (int r = 0; r < rows(constraint); ++r) check.magnitudes[r] = magnitudes.of({c, r});
    const Entity& last = m.entities[constraint.operands.back()];
    if (modulo_pi && !last.fixed && !driven[last.first])
      angles_.push_back(check.angle = last.first);
    const bool rests =
        std::ranges::all_of(constraint.operands, [&](EntityId id) { return m.is_at_rest(id); });
    (constraint.left_out != 0 && !rests && !is_implied(m, constraint) ? always_ : others_)
        .push_back(check);
  }
}

int BranchMonitor::violated(const Instant& instant, bool angles_follow) {
  if (instant.interpolated) return -1;
  const auto violated = [&](const std::vector<Check>& checks) {
    const auto it =
        std::ranges::find_if(checks, [&](const Check& check) { return !holds(check, instant); });
    return it == checks.end() ? -1 : it->constraint;
  };
  int found = violated(always_);
  if (found < 0 && !angles_follow) found = violated(others_);
  if (found < 0)
    for (const int angle : angles_) last_[angle] = instant.q[angle];
  return found;
}

bool BranchMonitor::holds(const Check& check, const Instant& instant) const {
  const Model& m = model_;
  const Constraint& constraint = m.constraints[check.constraint];
  const bool has_rate = check.has_rate && !instant.qd.empty();
  constexpr std::array<double, 3> at_rest{};
  bool holds = true;
  visit_kind(constraint.kind, [&]<class Kind>(Kind) {
    std::array<const double*, Kind::operand_sizes.size()> x, v;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Entity& e = m.entities[constraint.operands[k]];
      x[k] = (e.fixed ? m.fixed_values.data() : instant.q.data()) + e.first;
      v[k] = e.fixed || !has_rate ? at_rest.data() : instant.qd.data() + e.first;
    }
    std::array<double, Kind::rows> phi, rate{}, size, rate_size{};
    std::copy_n(check.magnitudes.begin(), Kind::rows, size.begin());
    Kind::residual(x.data(), constraint.constants.data(), phi.data());
    Kind::jacobian(x.data(), constraint.constants.data(),
                   [&](int row, int operand, int i, double value) {
                     size[row] += std::abs(value * x[operand][i]);
                     if (holds_modulo_pi<Kind> && operand + 1 == static_cast<int>(x.size()))
                       holds = holds && value <= 0;
                     rate[row] += value * v[operand][i];
                     rate_size[row] += std::abs(value * v[operand][i]);
                   });
    if (check.angle >= 0)
      holds = holds && std::abs(instant.q[check.angle] - last_[check.angle]) <= std::numbers::pi;
    for (int r = 0; r < Kind::rows; ++r)
      if (constraint.left_out >> r & 1)
        holds = holds && std::abs(phi[r]) <= allowed_ * size[r] &&
                std::abs(rate[r]) <= allowed_ * (rate_size[r] + size[r]);
  });
  return holds;
}

}  // namespace desmo
