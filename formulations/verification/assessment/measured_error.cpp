#include "formulations/verification/assessment/measured_error.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/assessment/backward_error.h"
#include "formulations/verification/assessment/enclosed_motion.h"

namespace desmo {

namespace {

/// Corrections have to shrink so fast: at a double root they halve.
constexpr double shrinks = 0.125;
/// Corrections, in magnitudes, after which there need be no more, and which are too large for a
/// last one.
constexpr double settled = 1e-19, too_large = 1e-13;
constexpr int max_corrections = 8;
/// What is stated of a measured error, and of what the last corrections may make of each level.
constexpr double margin = 1.25, of_rounding = 8;

}  // namespace

MeasuredError::MeasuredError(const Model& m, ScaledSystem& system, std::span<const Level> levels,
                             std::span<const Level> asked)
    : model_(m),
      system_(system),
      levels_(levels),
      asked_(asked),
      row_levels_(levels_of_rows(m, levels)),
      state_(m.state_size()),
      phi_(system.size()),
      position_(m.state_size()),
      off_(system.size()) {
  for (std::size_t i = 0; i < m.fixed_values.size(); ++i) {
    state_[m.coordinates() + i] = Wide(m.fixed_values[i]);
    position_[m.coordinates() + i] = m.fixed_values[i];
  }
}

PerLevel<double> MeasuredError::operator()(const Instant& instant, const Scales& scales,
                                           double condition) {
  take(instant);
  std::ranges::copy(instant.q, position_.begin());
  double rest = system_.factor(position_) ? 0 : INFINITY;  // that rounding leaves, in magnitudes
  PerLevel<double> result{};
  for (const Level level : levels) {
    if (level == Level::velocity && instant.qd.empty()) break;
    if (level == Level::acceleration && instant.qdd.empty()) break;
    rest = rest < INFINITY ? condition * rest + refine(level) : INFINITY;
    const auto unit = [](double magnitude, double scale) {
      return scale > 0 ? magnitude / scale : 0;
    };
    const double units =
        std::max(unit(nominal_size(model_), scales.length[level]), unit(1, scales.rotation[level]));
    result[level] = rest < INFINITY
                        ? margin * error(instant, level, scales) + of_rounding * rest * units
                        : INFINITY;
  }
  return result;
}

/// Takes an instant, with the drivers as they are meant.
void MeasuredError::take(const Instant& instant) {
  const auto given = [&](Level level, std::span<const double> values, int i) {
    return values.empty() || levels_[i] < level ? Wide(0) : Wide(values[i]);
  };
  for (int i = 0; i < model_.coordinates(); ++i)
    state_[i] = {instant.q[i], given(Level::velocity, instant.qd, i),
                 given(Level::acceleration, instant.qdd, i)};
  for (const Driver& d : model_.drivers) {
    const MotionSample<Wide> z = sample(d.motion, Wide(instant.time));
    state_[model_.entities[d.coordinate].first] = {z.position, z.velocity, z.acceleration};
  }
}

/// Solves one level, given the lower ones. Returns the last correction; infinity where corrections
/// do not shrink fast.
double MeasuredError::refine(Level level) {
  double before = INFINITY;
  for (int i = 0; i < max_corrections && system_.size() > 0; ++i) {
    system_.equations().residual<Jet<Wide>>(state_, phi_);
    for (int r = 0; r < system_.size(); ++r)
      off_[r] = row_levels_[r] < level
                    ? 0
                    : static_cast<double>(phi_[r].*order_of<Wide>(level)) / system_.row_sums()[r];
    system_.solve(off_.data());
    double correction = 0, size = 1;
    for (int j = 0; j < system_.size(); ++j) {
      const int at = system_.unknowns()[j];
      if (levels_[at] < level) continue;
      Wide& value = state_[at].*order_of<Wide>(level);
      value -= Wide(system_.magnitude(at)) * off_[j];
      correction = std::max(correction, std::abs(off_[j]));
      size = std::max(size, static_cast<double>(std::abs(value)) / system_.magnitude(at));
    }
    if (correction <= settled * size) return correction;
    if (!(correction <= shrinks * before))
      return correction <= too_large * size ? std::max(correction, before) : INFINITY;
    before = correction;
  }
  return system_.size() == 0 ? 0 : INFINITY;
}

/// Returns the largest difference of any output, relative to its scale.
double MeasuredError::error(const Instant& instant, Level level, const Scales& scales) const {
  const std::span<const double> values = level == Level::position   ? instant.q
                                         : level == Level::velocity ? instant.qd
                                                                    : instant.qdd;
  double largest = 0;
  for (const Entity& e : model_.entities) {
    if (e.fixed || asked_[e.first] < level) continue;
    const double scale = scales.of(e.kind, level);
    if (!(scale > 0)) continue;
    double squares = 0;
    for (int i = e.first; i < e.first + e.size; ++i) {
      const double off = static_cast<double>(values[i] - state_[i].*order_of<Wide>(level));
      squares += off * off;
    }
    largest = std::max(largest, std::sqrt(squares) / scale);
  }
  return largest;
}

}  // namespace desmo
