#include "formulations/verification/assessment/enclosed_motion.h"

#include <algorithm>
#include <cmath>

#include "formulations/base/per_level.h"

namespace desmo {

EnclosedMotion::EnclosedMotion(const Model& m, std::span<const Level> solved)
    : model_(m),
      levels_(solved),
      entity_(entity_of_coordinate(m)),
      state_(m.state_size()),
      positions_(m.state_size()) {
  for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
    state_[m.coordinates() + i] = Rounded(m.fixed_values[i]);
}

void EnclosedMotion::take(const Instant& instant) {
  const auto given = [&](Level level, std::span<const double> values, int i) {
    return values.empty() || !is_solved(i, level) ? 0 : values[i];
  };
  for (int i = 0; i < model_.coordinates(); ++i)
    state_[i] = {instant.q[i], given(Level::velocity, instant.qd, i),
                 given(Level::acceleration, instant.qdd, i)};
  for (const Driver& d : model_.drivers) {
    const MotionSample<Rounded> meant = sample(d.motion, Rounded(instant.time));
    Jet<Rounded>& used = state_[model_.entities[d.coordinate].first];
    const auto add = [](Rounded& x, const Rounded& z) {
      x.radius = z.radius + std::abs(z.value - x.value);
    };
    add(used.value, meant.position);
    if (!instant.qd.empty()) add(used.first, meant.velocity);
    if (!instant.qdd.empty()) add(used.second, meant.acceleration);
  }
}

void EnclosedMotion::widen(Level level, std::span<const int> unknowns,
                           const Eigen::ArrayXd& errors) {
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    if (const int i = unknowns[j]; is_solved(i, level))
      (state_[i].*order_of<Rounded>(level)).radius = errors[static_cast<Eigen::Index>(j)];
}

double EnclosedMotion::of_drivers(Level level, const Scales& scales) const {
  double worst = 0;
  for (const Driver& d : model_.drivers) {
    const int i = model_.entities[d.coordinate].first;
    const double radius = (state_[i].*order_of<Rounded>(level)).radius;
    if (radius > 0) worst = std::max(worst, radius / scale(i, level, scales));
  }
  return worst;
}

std::span<const Rounded> EnclosedMotion::positions() {
  std::ranges::transform(state_, positions_.begin(), &Jet<Rounded>::value);
  return positions_;
}

}  // namespace desmo
