#include "formulations/safety/assessor.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

Assessment undetermined(Assessment a, GroupId group) {
  a.singular = true;
  a.group = group;
  for (const Level level : levels) a.bound[level] = INFINITY;
  return a;
}

std::vector<Level> all_levels(const Mechanism& m, std::span<const Level> given) {
  std::vector<Level> result(given.begin(), given.end());
  result.resize(m.coordinates(), Level::acceleration);
  return result;
}

}  // namespace

Assessor::Assessor(const Mechanism& m, std::span<const Level> levels)
    : mechanism_(m),
      levels_(all_levels(m, levels)),
      system_(m),
      motion_(m, levels_),
      norm_(system_.size()),
      weights_(system_.size()),
      right_(system_.size()),
      change_(system_.size()),
      state_(m.state_size()),
      phi_(system_.size()),
      phi_motion_(system_.size()) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
  for (const Constraint& c : m.constraints) {  // to which level a row has all that it joins
    Level level = Level::acceleration;
    for (const EntityId e : c.operands)
      if (!m.entities[e].fixed) level = std::min(level, levels_[m.entities[e].first]);
    row_levels_.insert(row_levels_.end(), kept_rows(c), level);
  }
  for (const Level level : desmo::levels) corrected_[level].resize(m.coordinates());
}

Assessment Assessor::operator()(const Instant& instant, const Scales& scales) {
  Assessment a;
  motion_.take(instant);
  std::ranges::copy(instant.q, state_.begin());
  if (!system_.factorise(state_)) {
    a.condition = INFINITY;
    return undetermined(a, system_.singular_group());
  }
  if (system_.size() > 0) {
    weights_.setOnes();
    right_.setOnes();
    const WorstCase worst = norm_(system_, weights_, right_);
    a.condition = worst.value;
    a.group = motion_.group(system_.unknowns()[worst.unknown]);
  }

  system_.equations().residual<Rounded>(motion_.positions(), phi_);
  for (int r = 0; r < system_.size(); ++r) right_[r] = phi_[r].most() / system_.row_sums()[r];
  const double distance = outputs(Level::position, scales);  // δ
  motion_.widen(Level::position, 2 * distance, scales);
  const double closeness = contraction(a.condition);  // η
  if (!(closeness < 0.5)) return undetermined(a, a.group);
  const double share = 1 / (1 - closeness);
  a.bound.position = share * distance;
  motion_.widen(Level::position, a.bound.position, scales);
  if (instant.qd.empty()) return a;

  a.bound.velocity = share * rates(Level::velocity, scales);
  motion_.widen(Level::velocity, a.bound.velocity, scales);
  if (!instant.qdd.empty()) a.bound.acceleration = share * rates(Level::acceleration, scales);
  return a;
}

/// max |A⁻¹| right over all outputs, each relative to its scale, and the drivers' own errors.
double Assessor::outputs(Level level, const Scales& scales) {
  for (int j = 0; j < system_.size(); ++j) {
    const int i = system_.unknowns()[j];
    const double scale = motion_.scale(i, level, scales);
    weights_[j] = scale > 0 && motion_.is_solved(i, level)
                      ? system_.magnitude(i) * std::sqrt(motion_.size_of_output(i)) / scale
                      : 0;
  }
  return std::max(norm_(system_, weights_, right_).value, motion_.of_drivers(level, scales));
}

/// By how much Φ_φ changes at most within the bounds of position, against itself.
double Assessor::contraction(double condition) {
  if (system_.size() == 0) return 0;
  change_.setZero();
  system_.equations().jacobian<Rounded>(motion_.positions(),
                                        [&](int row, int i, const Rounded& value) {
                                          if (system_.is_unknown(i))
                                            change_[row] += value.radius * system_.magnitude(i);
                                        });
  return condition * (change_ / system_.row_sums()).maxCoeff<Eigen::PropagateNaN>();
}

double Assessor::rates(Level level, const Scales& scales) {
  system_.equations().residual<Jet<Rounded>>(motion_.state(), phi_motion_);
  for (int r = 0; r < system_.size(); ++r)
    right_[r] = row_levels_[r] >= level
                    ? (phi_motion_[r].*order_of<Rounded>(level)).most() / system_.row_sums()[r]
                    : 0;
  return outputs(level, scales);
}

/// values −= Φ_φ⁻¹ of that order of the equations; the largest correction in natural magnitudes.
double Assessor::correct(Level level, std::vector<double>& values) {
  if (system_.size() == 0) return 0;
  system_.equations().residual<Jet<Rounded>>(motion_.state(), phi_motion_);
  for (int r = 0; r < system_.size(); ++r)
    right_[r] = row_levels_[r] >= level
                    ? (phi_motion_[r].*order_of<Rounded>(level)).value / system_.row_sums()[r]
                    : 0;
  system_.solve(right_.data());
  for (int j = 0; j < system_.size(); ++j) {
    const int i = system_.unknowns()[j];
    if (motion_.is_solved(i, level)) values[i] -= system_.magnitude(i) * right_[j];
  }
  return right_.abs().maxCoeff<Eigen::PropagateNaN>();
}

Instant Assessor::corrected(const Instant& instant) {
  constexpr int most_corrections = 10;
  auto& [q, qd, qdd] = corrected_;
  Instant result = instant;
  const auto put = [](std::span<const double> from, std::vector<double>& to) {
    std::ranges::copy(from, to.begin());
    return from.empty() ? from : std::span<const double>(to);
  };
  result.q = put(instant.q, q);
  result.qd = put(instant.qd, qd);
  result.qdd = put(instant.qdd, qdd);
  double before = INFINITY;
  for (int i = 0; i < most_corrections; ++i) {
    std::ranges::copy(q, state_.begin());
    if (!system_.factorise(state_)) return instant;
    motion_.take(result);
    const double correction = correct(Level::position, q);
    if (!(correction < before / 2)) break;
    before = correction;
  }
  for (int pass = 0; pass < 2; ++pass)  // the second refines what the first has solved
    for (const Level level : {Level::velocity, Level::acceleration})
      if (!(level == Level::velocity ? result.qd : result.qdd).empty()) {
        motion_.take(result);
        correct(level, corrected_[level]);
      }
  return result;
}

}  // namespace desmo
