#include "formulations/verification/assessment/backward_error.h"

#include <algorithm>
#include <cmath>

#include "formulations/scaling/scales.h"

namespace desmo {

std::vector<Level> levels_of_rows(const Model& m, std::span<const Level> levels) {
  std::vector<Level> result;
  for (const Constraint& c : m.constraints) {
    Level level = Level::acceleration;
    for (const EntityId e : c.operands)
      if (!m.entities[e].fixed) level = std::min(level, levels[m.entities[e].first]);
    result.insert(result.end(), kept_rows(c), level);
  }
  return result;
}

BackwardError::BackwardError(const Model& m, const WholeSystem& equations,
                             std::span<const Level> levels)
    : model_(m),
      levels_(levels),
      row_levels_(levels_of_rows(m, levels)),
      equations_(equations),
      size_(nominal_size(m)),
      sums_(Eigen::ArrayXd::Ones(row_levels_.size())),
      state_(m.state_size()),
      phi_(row_levels_.size()) {
  for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
    state_[m.coordinates() + i] = m.fixed_values[i];
}

void BackwardError::take_row_sums(const ScaledSystem& system) {
  sums_ = system.row_sums() * system.row_shares();
}

PerLevel<double> BackwardError::operator()(const Instant& instant, const Scales& scales,
                                           double condition) {
  const auto rate = [&](std::span<const double> values, Level level, int i) {
    return values.empty() || levels_[i] < level ? 0 : values[i];
  };
  for (int i = 0; i < model_.coordinates(); ++i)
    state_[i] = {instant.q[i], rate(instant.qd, Level::velocity, i),
                 rate(instant.qdd, Level::acceleration, i)};
  PerLevel<double> of_drivers;  // which interpolation leaves
  for (const Driver& d : model_.drivers) {
    const Entity& e = model_.entities[d.coordinate];
    const MotionSample<double> z = sample(d.motion, instant.time);
    Jet<double>& used = state_[e.first];
    const auto meet = [&](Level level, double& value, double meant) {
      if (const double scale = scales.of(e.kind, level); scale > 0)
        of_drivers[level] = std::max(of_drivers[level], std::abs(value - meant) / scale);
      value = meant;
    };
    meet(Level::position, used.value, z.position);
    if (!instant.qd.empty()) meet(Level::velocity, used.first, z.velocity);
    if (!instant.qdd.empty()) meet(Level::acceleration, used.second, z.acceleration);
  }
  equations_.residual<Jet<double>>(state_, phi_);
  PerLevel<double> off;  // the largest of each level, in magnitudes of the whole mechanism
  for (int r = 0; r < sums_.size(); ++r) {
    const auto add = [&](Level level, double value) {
      if (sums_[r] > 0 && row_levels_[r] >= level)
        off[level] =
            std::max(off[level], std::isnan(value) ? INFINITY : std::abs(value) / sums_[r]);
    };
    add(Level::position, phi_[r].value);
    if (!instant.qd.empty()) add(Level::velocity, phi_[r].first);
    if (!instant.qdd.empty()) add(Level::acceleration, phi_[r].second);
  }
  const auto in_scale = [](double magnitude, double scale) {
    return scale > 0 ? magnitude / scale : 0;
  };
  for (const Level level : all_levels)
    off[level] *= condition * std::max(in_scale(size_, scales.length[level]),
                                       in_scale(1, scales.rotation[level]));
  for (const Level level : all_levels) off[level] = std::max(off[level], of_drivers[level]);
  return off;
}

}  // namespace desmo
