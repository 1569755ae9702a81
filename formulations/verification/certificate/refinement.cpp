#include "formulations/verification/certificate/refinement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/numbers/interval.h"
#include "formulations/scaling/scales.h"

namespace desmo {

Refinement::Refinement(const Model& m, std::span<const Level> levels, InitialResidual initial)
    : m_(m), certifier_(m, levels, initial) {
  for (const Entity& e : m.entities)
    if (!e.fixed) kind_.insert(kind_.end(), e.size, is_length(e.kind) ? 0 : 1);
  for (Values* values : {&next_, &radius_, &best_, &best_radius_, &rest_})
    for (const Level level : all_levels) (*values)[level].resize(m.coordinates());
}

const RefinedInstant& Refinement::refine(const Instant& instant) {
  levels_ = std::span(all_levels).first(instant.qd.empty() ? 1 : instant.qdd.empty() ? 2 : 3);
  const PerLevel<std::span<const double>> given{instant.q, instant.qd, instant.qdd};
  for (const Level level : levels_) std::ranges::copy(given[level], next_[level].begin());
  result_ = {.instant = instant};
  Instant present = instant;
  const auto show = [&](Instant& to, const Values& values) {
    to.q = values.position;
    if (!given.velocity.empty()) to.qd = values.velocity;
    if (!given.acceleration.empty()) to.qdd = values.acceleration;
  };
  show(present, next_);
  PerLevel<double> least{INFINITY, INFINITY, INFINITY};
  for (int left = max_passes; left > 0; --left) {
    ++result_.passes;
    const Certificate c = certifier_.certify(present);
    if (result_.proven && !c.proven) break;
    result_.last = c;
    add_corrections(c);
    if (!c.proven) continue;
    if (!result_.proven) left = max_passes;  // an instant that was far off has yet to settle
    const PerLevel<double> open = open_digits();
    // Each level counts by itself: where a motion rests, rates are nothing but rounding.
    const auto falls_below = [&](double share) {
      return std::ranges::any_of(levels_, [&](Level l) { return open[l] < share * least[l]; });
    };
    if (result_.proven && !falls_below(1)) break;
    const bool halves = falls_below(0.5);
    least = open;
    result_.proven = true;
    best_ = next_;
    best_radius_ = radius_;
    const bool is_right = std::ranges::all_of(levels_, [&](Level l) { return open[l] <= 1; });
    if (is_right || !halves) break;
  }
  if (result_.proven) {
    show(result_.instant, best_);
    for (const Level level : all_levels) result_.radius[level] = best_radius_[level];
  } else {
    result_.radius = result_.last.radius;
  }
  return result_;
}

/// Adds the corrections, and finds radii of the sums: what corrections leave, and the rounding of
/// the sum, which is known exactly.
void Refinement::add_corrections(const Certificate& c) {
  for (const Level level : all_levels)
    for (int i = 0; i < m_.coordinates(); ++i) {
      double& x = next_[level][i];
      const double correction = c.correction[level][i];
      const double sum = x + correction;
      const double of_correction = sum - x;
      const double rounding = (x - (sum - of_correction)) + (correction - of_correction);
      rest_[level][i] = std::isfinite(c.rest[level][i]) ? c.rest[level][i] : 0;
      radius_[level][i] = (c.rest[level][i] + std::abs(rounding)) * (1 + 2 * Interval::unit);
      x = sum;
    }
}

/// Returns what the corrections leave at each level, in roundings of the largest number of its
/// kind. Below one, nothing is left to correct. A kind that does not move has the size that the
/// other's rates, or its velocity, give it (Scales).
PerLevel<double> Refinement::open_digits() const {
  PerLevel<std::array<double, 2>> rest{}, size{};
  size.position[1] = 1;  // [rad]
  for (const Level level : levels_)
    for (int i = 0; i < m_.coordinates(); ++i) {
      const int kind = kind_[i];
      rest[level][kind] = std::max(rest[level][kind], rest_[level][i]);
      if (const double x = std::abs(next_[level][i]); std::isfinite(x))
        size[level][kind] = std::max(size[level][kind], x);
    }
  auto& [q, v, a] = size;
  if (v[0] == 0) v[0] = v[1] * q[0];
  if (v[1] == 0 && q[0] > 0) v[1] = v[0] / q[0];
  for (const int kind : {0, 1})
    if (q[kind] > 0) a[kind] = std::max(a[kind], v[kind] * (v[kind] / q[kind]));
  PerLevel<double> most{};
  for (const Level level : levels_)
    for (const int kind : {0, 1})
      if (size[level][kind] > 0)
        most[level] =
            std::max(most[level], rest[level][kind] / (Interval::unit * size[level][kind]));
  return most;
}

}  // namespace desmo
