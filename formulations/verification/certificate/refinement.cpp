#include "formulations/verification/certificate/refinement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/numbers/interval.h"
#include "formulations/model/scales.h"

namespace desmo {

namespace {

/// What a pass leaves of the bounds on errors, at most, while Newton's method converges. A proof of
/// errors e needs 16 c e < 1, c e² being the next ones (curvature c). So these are less than e/16,
/// and bounds are of second order. What falls less is rounding.
constexpr double max_left = 1.0 / 256;

}  // namespace

Refinement::Refinement(const Model& m, std::span<const Level> levels, InitialResidual initial)
    : m_(m), certifier_(m, levels, initial) {
  for (const Entity& e : m.entities)
    if (!e.fixed) kind_.insert(kind_.end(), e.size, is_length(e.kind) ? 0 : 1);
  for (Values* values : {&next_, &radius_, &best_, &best_radius_})
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
  PerLevel<std::array<double, 2>> least{};
  ErrorSets sets = ErrorSets::boxes;
  for (int left = max_passes; left > 0; --left) {
    ++result_.passes;
    const Certificate c = certifier_.certify(present, sets);
    if (result_.proven && !c.proven) break;
    result_.last = c;
    add_corrections(c);
    if (!c.proven) continue;
    if (!result_.proven) left = max_passes;  // an instant that was far off has yet to settle
    const PerLevel<Digits> now = digits(c);
    // Each level counts by itself: where a motion rests, rates are nothing but rounding.
    bool converges = false, is_right = true;
    double before = 0;
    for (const Level level : levels_) {
      is_right &= now[level].open <= 1;
      before = std::max(before, now[level].before);
      // Sizes of rates fall, too, where a motion rests: what counts is the error itself.
      double share = result_.proven ? 1 : 0;
      for (const int kind : {0, 1})
        if (least[level][kind] > 0) share *= now[level].rest[kind] / least[level][kind];
      if (result_.proven && !(share < 1)) continue;
      converges |= share < max_left;
      least[level] = now[level].rest;
      best_[level] = next_[level];
      best_radius_[level] = radius_[level];
    }
    result_.proven = true;
    if (is_right) break;
    // What another pass takes off is of second order in the errors: is it seen in the last digit?
    const double second = c.condition * before;
    if (converges && second * second * Interval::unit > 0.5) continue;
    if (sets == ErrorSets::bases || !certifier_.has_long_chains()) break;
    sets = ErrorSets::bases;
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
      radius_[level][i] = (c.rest[level][i] + std::abs(rounding)) * (1 + 2 * Interval::unit);
      x = sum;
    }
}

/// Returns the errors at each level. A kind that does not move has the size that the other's rates,
/// or its velocity, give it (Scales).
PerLevel<Refinement::Digits> Refinement::digits(const Certificate& c) const {
  PerLevel<Digits> result{};
  PerLevel<std::array<double, 2>> correction{}, size{};
  size.position[1] = 1;  // [rad]
  for (const Level level : levels_)
    for (int i = 0; i < m_.coordinates(); ++i) {
      const int kind = kind_[i];
      if (const double r = c.rest[level][i]; std::isfinite(r))
        result[level].rest[kind] = std::max(result[level].rest[kind], r);
      correction[level][kind] = std::max(correction[level][kind], std::abs(c.correction[level][i]));
      if (const double x = std::abs(next_[level][i]); std::isfinite(x))
        size[level][kind] = std::max(size[level][kind], x);
    }
  auto& [q, v, a] = size;
  if (v[0] == 0) v[0] = v[1] * q[0];
  if (v[1] == 0 && q[0] > 0) v[1] = v[0] / q[0];
  for (const int kind : {0, 1})
    if (q[kind] > 0) a[kind] = std::max(a[kind], v[kind] * (v[kind] / q[kind]));
  for (const Level level : levels_)
    for (const int kind : {0, 1}) {
      const double unit = Interval::unit * size[level][kind];
      if (!(unit > 0)) continue;
      Digits& most = result[level];
      most.open = std::max(most.open, most.rest[kind] / unit);
      most.before = std::max(most.before, (correction[level][kind] + most.rest[kind]) / unit);
    }
  return result;
}

}  // namespace desmo
