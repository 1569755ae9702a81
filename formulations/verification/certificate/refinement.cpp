#include "formulations/verification/certificate/refinement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/numbers/interval.h"
#include "formulations/model/scales.h"
#include "formulations/verification/certificate/certified_instant.h"

namespace desmo {

namespace {

/// Limit of the ratio of a pass' bounds to those of the best pass before (<), below which Newton's
/// method still converges. A pass takes errors e to c e² with the curvature c. A proof of e needs
/// 16 c e < 1, so less than e/16 is left. Bounds are of second order in e: less than 1/256 of them
/// is left. Bounds that fall less are rounding.
constexpr double max_left = 1.0 / 256;

constexpr int count = LaneNumbers::count;

/// Returns x where the mask is true, elsewhere 0.
LaneNumbers where(LaneMask mask, const LaneNumbers& x) {
  return LaneNumbers((LaneNumbers::Numbers)((LaneNumbers::Bits)x.v & mask.bits));
}
LaneNumbers finite(const LaneNumbers& x) { return where(is_finite(x), x); }

double largest(const LaneNumbers& x) { return std::max({x[0], x[1], x[2], x[3]}); }

}  // namespace

Refinement::Refinement(const Model& m, std::span<const Level> levels)
    : m_(m), certifier_(m, levels), unbounded_(m.coordinates(), INFINITY) {
  lengths_.resize((m.coordinates() + count - 1) / count);
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && is_length(e.kind) && i < e.first + e.size; ++i)
      lengths_[i / count].bits[i % count] = -1;
  for (Values* values : {&next_, &radius_, &best_, &best_radius_})
    for (const Level level : all_levels) (*values)[level].resize(m.coordinates());
}

const RefinedInstant& Refinement::refine(const Instant& instant) {
  const PerLevel<std::span<const double>> given{instant.q, instant.qd, instant.qdd};
  levels_ = levels_of(given);
  for (const Level level : levels_) std::ranges::copy(given[level], next_[level].begin());
  result_ = {.instant = instant};
  const auto with = [&](const Values& values) {
    return with_values(instant, {values.position, values.velocity, values.acceleration});
  };
  const Instant present = with(next_);
  PerLevel<std::array<double, 2>> least{};
  ErrorSets sets = ErrorSets::boxes;
  for (int left = max_passes; left > 0; --left) {
    ++result_.passes;
    const Certificate c = certifier_.certify(present, sets);
    if (result_.proven && !c.proven) break;
    result_.last = c;
    add_corrections(c);
    if (!c.proven) continue;
    if (!result_.proven) left = max_passes;  // an instant that was far off has yet to converge
    const PerLevel<Digits> now = digits(c);
    // Each level keeps its own best pass: where a motion rests, rates are mere rounding.
    bool converges = false, is_right = true;
    double before = 0;
    for (const Level level : levels_) {
      is_right &= now[level].open <= 1;
      before = std::max(before, now[level].before);
      // Multiplies the ratios of both kinds. Compares errors themselves, not errors over sizes:
      // sizes of rates shrink, too, at rest.
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
    // A unit is u × the largest number of the kind, κ the condition number. After errors of
    // `before` units, another pass changes (κ before)² u units. It is worth its time above half a
    // unit.
    const double second = c.condition * before;
    if (converges && second * second * Interval::unit > 0.5) continue;
    if (sets == ErrorSets::bases || !certifier_.has_long_chains()) break;
    sets = ErrorSets::bases;
  }
  if (result_.proven) result_.instant = with(best_);
  for (const Level level : levels_)
    result_.radius[level] = result_.proven ? best_radius_[level] : unbounded_;
  return result_;
}

/// Adds the corrections to next_, and writes the radii of the sums to radius_: what corrections
/// leave, plus the rounding of the sum, which TwoSum (Knuth) finds exactly.
void Refinement::add_corrections(const Certificate& c) {
  for (const Level level : all_levels) {
    const double *correction = c.correction[level].data(), *rest = c.rest[level].data();
    double *x = next_[level].data(), *radius = radius_[level].data();
#pragma omp simd
    for (int i = 0; i < m_.coordinates(); ++i) {
      const double sum = x[i] + correction[i];
      const double of_correction = sum - x[i];
      const double rounding = (x[i] - (sum - of_correction)) + (correction[i] - of_correction);
      radius[i] = (rest[i] + std::abs(rounding)) * (1 + 2 * Interval::unit);
      x[i] = sum;
    }
  }
}

/// Returns bounds on the errors at each level, over the largest numbers of each kind. The largest
/// numbers are completed like Scales: a kind at rest takes the velocity of the other kind, and
/// accelerations count as at least velocity²/size.
PerLevel<Refinement::Digits> Refinement::digits(const Certificate& c) const {
  PerLevel<Digits> result{};
  PerLevel<std::array<double, 2>> correction{}, size{};
  size.position[1] = 1;  // [rad]
  for (const Level level : levels_) {
    const std::span<const double> left = c.rest[level], by = c.correction[level],
                                  values = next_[level];
    std::array<LaneNumbers, 2> rests{}, corrections{}, sizes{};
    for (std::size_t k = 0; k < lengths_.size(); ++k) {
      const LaneNumbers r = finite(LaneNumbers::load(left, count * k)),
                        d = abs(LaneNumbers::load(by, count * k)),
                        x = finite(abs(LaneNumbers::load(values, count * k)));
      for (const int kind : {0, 1}) {
        const LaneMask of_kind = kind == 0 ? lengths_[k] : !lengths_[k];
        const auto raise = [&](LaneNumbers& most, const LaneNumbers& to) {
          most = max(where(of_kind, to), most);
        };
        raise(rests[kind], r), raise(corrections[kind], d), raise(sizes[kind], x);
      }
    }
    for (const int kind : {0, 1}) {
      result[level].rest[kind] = largest(rests[kind]);
      correction[level][kind] = largest(corrections[kind]);
      size[level][kind] = std::max(size[level][kind], largest(sizes[kind]));
    }
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
