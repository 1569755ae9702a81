#include "formulations/verification/assessment/measured_error.h"

#include <Eigen/Core>
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "formulations/verification/assessment/backward_error.h"
#include "formulations/verification/assessment/enclosed_motion.h"
#include "formulations/verification/assessment/limits.h"

namespace desmo {

namespace {

/// Corrections have to shrink so fast: at a double root they halve.
constexpr double shrinks = 0.125;
/// A correction, in magnitudes, that is too large for a last one.
constexpr double too_large = 1e-13;
constexpr int max_corrections = 24;
/// Margin of a measured error for scales, and of the last correction for what it may leave.
constexpr double margin = 1.01, of_rounding = 8;

/// An error, and what the rounding of the measurement may have made of it, relative to scales.
struct Measurement {
  PerLevel<double> error{}, rounding{};

  /// Returns the bounds. The margin alone does not take one above its limit.
  PerLevel<double> stated(const PerLevel<double>& limit) const {
    PerLevel<double> sum{};
    for (const Level l : all_levels) {
      sum[l] = margin * error[l] + rounding[l];
      if (error[l] + rounding[l] <= limit[l]) sum[l] = std::min(sum[l], limit[l]);
    }
    return sum;
  }
};

}  // namespace

template <class Wide>
class MeasuredError::Refinement {
 public:
  Refinement(const Model& m, ScaledSystem& system, std::span<const Level> levels,
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

  /// Makes one of other numbers for the same model.
  template <class Other>
  explicit Refinement(const Refinement<Other>& like)
      : Refinement(like.model_, like.system_, like.levels_, like.asked_) {}

  Measurement operator()(const Instant& instant, const Scales& scales, const Assessment& a);

 private:
  template <class>
  friend class Refinement;

  void take(const Instant& instant);
  double refine(Level level);
  double error(const Instant& instant, Level level, const Scales& scales) const;

  const Model& model_;
  ScaledSystem& system_;
  std::span<const Level> levels_, asked_;
  std::vector<Level> row_levels_;
  std::vector<Jet<Wide>> state_, phi_;
  std::vector<double> position_;  // state at which the system is factorised
  Eigen::ArrayXd off_;
};

template <class Wide>
Measurement MeasuredError::Refinement<Wide>::operator()(const Instant& instant,
                                                        const Scales& scales, const Assessment& a) {
  const double finer = static_cast<double>(std::numeric_limits<Wide>::epsilon()) /
                       std::numeric_limits<double>::epsilon();
  take(instant);
  std::ranges::copy(instant.q, position_.begin());
  double rest = system_.factor(position_) ? finer * a.rounding : INFINITY;
  Measurement result;
  for (const Level level : all_levels) {
    if (level == Level::velocity && instant.qd.empty()) break;
    if (level == Level::acceleration && instant.qdd.empty()) break;
    const auto over = [&](Level of, double length, double rotation) {
      const auto ratio = [](double x, double scale) { return scale > 0 ? x / scale : 0; };
      return std::max(ratio(length, scales.length[of]), ratio(rotation, scales.rotation[of]));
    };
    const double size = nominal_size(model_);
    if (level > Level::position) rest *= a.condition;
    if (level == Level::acceleration) {  // of which velocities squared are a part
      const double v = scales.length.velocity, w = scales.rotation.velocity;
      rest *= std::max(1.0, over(level, v * v / size, w * w));
    }
    if (rest < INFINITY) rest += of_rounding * refine(level) * over(level, size, 1);
    result.rounding[level] = rest;
    if (rest < INFINITY) result.error[level] = error(instant, level, scales);
  }
  return result;
}

/// Takes an instant, with the drivers as they are meant.
template <class Wide>
void MeasuredError::Refinement<Wide>::take(const Instant& instant) {
  const auto given = [&](Level level, std::span<const double> values, int i) {
    return values.empty() || levels_[i] < level ? Wide(0) : Wide(values[i]);
  };
  for (int i = 0; i < model_.coordinates(); ++i)
    state_[i] = {Wide(instant.q[i]), given(Level::velocity, instant.qd, i),
                 given(Level::acceleration, instant.qdd, i)};
  for (const Driver& d : model_.drivers) {
    const MotionSample<Wide> z = sample(d.motion, Wide(instant.time));
    state_[model_.entities[d.coordinate].first] = {z.position, z.velocity, z.acceleration};
  }
}

/// Solves one level, given the lower ones. Returns the last correction; infinity where corrections
/// do not shrink fast.
template <class Wide>
double MeasuredError::Refinement<Wide>::refine(Level level) {
  const double settled = static_cast<double>(std::numeric_limits<Wide>::epsilon());
  double before = INFINITY;
  for (int i = 0; i < max_corrections && system_.size() > 0; ++i) {
    system_.equations().template residual<Jet<Wide>>(state_, phi_);
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
      value -= Wide(system_.magnitude(at)) * Wide(off_[j]);
      correction = std::max(correction, std::abs(off_[j]));
      size = std::max(size, std::abs(static_cast<double>(value)) / system_.magnitude(at));
    }
    if (correction <= settled * size) return correction;
    if (!(correction <= shrinks * before))
      return correction <= too_large * size ? std::max(correction, before) : INFINITY;
    before = correction;
  }
  return system_.size() == 0 ? 0 : INFINITY;
}

/// Returns the largest difference of any output, relative to its scale.
template <class Wide>
double MeasuredError::Refinement<Wide>::error(const Instant& instant, Level level,
                                              const Scales& scales) const {
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
      const double off =
          static_cast<double>(Wide(Wide(values[i]) - state_[i].*order_of<Wide>(level)));
      squares += off * off;
    }
    largest = std::max(largest, std::sqrt(squares) / scale);
  }
  return largest;
}

struct MeasuredError::Refinements {
  Refinement<long double> extended;
  using Wide = boost::multiprecision::cpp_bin_float_quad;  // without libquadmath
  std::optional<Refinement<Wide>> quadruple{};
};

MeasuredError::MeasuredError(const Model& m, ScaledSystem& system, std::span<const Level> levels,
                             std::span<const Level> asked)
    : refinements_(new Refinements{{m, system, levels, asked}}) {}

MeasuredError::~MeasuredError() = default;

PerLevel<double> MeasuredError::operator()(const Instant& instant, const Scales& scales,
                                           const Assessment& a, const PerLevel<double>& limit) {
  auto& [extended, quadruple] = *refinements_;
  const Measurement m = extended(instant, scales, a);
  const bool decides = std::ranges::all_of(all_levels, [&](Level l) {
    return m.rounding[l] <= m.error[l] || m.rounding[l] <= limit[l];
  });
  if (!exceeds(m.stated(limit), limit) || (decides && exceeds(m.error, limit)))
    return m.stated(limit);
  if (!quadruple) quadruple.emplace(extended);
  return (*quadruple)(instant, scales, a).stated(limit);
}

}  // namespace desmo
