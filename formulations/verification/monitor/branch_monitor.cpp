#include "formulations/verification/monitor/branch_monitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "formulations/constraints/constraints.h"

namespace desmo {

namespace {

/// Limits of an equation's error relative to the sum of its terms: more than rounding, or a coarse
/// tolerance times `per_tolerance`, leaves, and less than another branch does.
constexpr double min_allowed = 1e-6, per_tolerance = 1e3, max_allowed = 0.1;

bool is_checked(const Constraint& constraint) {
  bool modulo_pi = false;
  visit_kind(constraint.kind, [&]<class Kind>(Kind) { modulo_pi = holds_modulo_pi<Kind>; });
  return modulo_pi || constraint.left_out != 0;
}

bool is_solved_to(const Model& m, std::span<const Level> solved, const Constraint& constraint,
                  Level level) {
  return solved.empty() || std::ranges::all_of(constraint.operands, [&](EntityId id) {
           return m.entities[id].fixed || solved[m.entities[id].first] >= level;
         });
}

}  // namespace

BranchMonitor::BranchMonitor(const Model& m, std::span<const Level> levels, double tolerance)
    : model_(m),
      levels_(levels.begin(), levels.end()),
      allowed_(std::clamp(per_tolerance * tolerance, min_allowed, max_allowed)),
      state_(m.state_size()),
      rate_(m.state_size()),
      last_(m.estimate),
      driven_(independent_coordinates(m)) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
    if (is_checked(m.constraints[c])) checked_.push_back(c);
}

int BranchMonitor::violated(const Instant& instant) {
  if (checked_.empty() || instant.interpolated) return -1;
  const Model& m = model_;
  std::ranges::copy(instant.q, state_.begin());
  std::ranges::copy(instant.qd, rate_.begin());
  for (const int c : checked_) {
    const Constraint& constraint = m.constraints[c];
    const bool has_rate =
        !instant.qd.empty() && is_solved_to(m, levels_, constraint, Level::velocity);
    bool holds = true;
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      std::array<const double*, Kind::operand_sizes.size()> x;
      std::array<int, Kind::operand_sizes.size()> first;
      for (std::size_t k = 0; k < x.size(); ++k) {
        first[k] = m.state_index(constraint.operands[k]);
        x[k] = state_.data() + first[k];
      }
      std::array<double, Kind::rows> phi, rate{}, size{}, rate_size{};
      Kind::residual(x.data(), constraint.constants.data(), phi.data());
      Kind::jacobian(x.data(), constraint.constants.data(),
                     [&](int row, int operand, int i, double value) {
                       const int at = first[operand] + i;
                       size[row] += std::abs(value * state_[at]);
                       if (holds_modulo_pi<Kind> && operand + 1 == static_cast<int>(x.size()))
                         holds = holds && value <= 0;
                       if (!has_rate) return;
                       rate[row] += value * rate_[at];
                       rate_size[row] += std::abs(value * rate_[at]);
                     });
      if constexpr (holds_modulo_pi<Kind>) {
        const std::size_t angle = first[x.size() - 1];
        if (angle < last_.size() && !driven_[angle])
          holds = holds && std::abs(state_[angle] - last_[angle]) <= std::numbers::pi;
      }
      for (int r = 0; r < Kind::rows; ++r)
        if (constraint.left_out >> r & 1)
          holds = holds && std::abs(phi[r]) <= allowed_ * size[r] &&
                  std::abs(rate[r]) <= allowed_ * (rate_size[r] + size[r]);
    });
    if (!holds) return c;
  }
  std::ranges::copy(instant.q, last_.begin());
  return -1;
}

}  // namespace desmo
