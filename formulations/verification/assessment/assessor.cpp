#include "formulations/verification/assessment/assessor.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "formulations/scaling/magnitudes.h"
#include "formulations/verification/assessment/backward_error.h"

namespace desmo {

namespace {

/// What the estimate of a norm may miss.
constexpr double missed = 3;

Assessment undetermined(Assessment a, GroupId group) {
  a.singular = true;
  a.group = group;
  for (const Level level : all_levels) a.bound[level] = INFINITY;
  return a;
}

std::vector<Level> given_or_highest(const Model& m, std::span<const Level> given) {
  std::vector<Level> result(given.begin(), given.end());
  result.resize(m.coordinates(), Level::acceleration);
  return result;
}

}  // namespace

Assessor::Assessor(const Model& m, std::span<const Level> levels, std::span<const Level> asked,
                   Norm norm)
    : model_(m),
      levels_(given_or_highest(m, levels)),
      asked_(asked.empty() ? levels_ : std::vector<Level>(asked.begin(), asked.end())),
      row_levels_(levels_of_rows(m, levels_)),
      system_(m, norm),
      motion_(m, levels_),
      of_system_(system_.size()),
      of_change_(of_system_),
      of_residuals_(of_system_),
      to_outputs_{of_system_, of_system_, of_system_},
      to_errors_(to_outputs_),
      weights_(system_.size()),
      off_(system_.size()),
      unknown_(system_.size()),
      change_(system_.size()),
      signs_(system_.size(), 2),
      row_(system_.size()),
      row_magnitudes_(system_.size()),
      error_(system_.size()),
      max_(m.groups.size()),
      max_length_(m.groups.size()),
      state_(m.state_size()),
      phi_(system_.size()),
      phi_motion_(system_.size()) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
  for (const int i : system_.unknowns())
    group_.push_back(norm == Norm::of_blocks ? motion_.group(i) : 0);
  const Magnitudes magnitudes(m);
  Eigen::Index row = 0;
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
    for (int r = 0; r < rows(m.constraints[c]); ++r)
      if (!(m.constraints[c].left_out >> r & 1)) row_magnitudes_[row++] = magnitudes.of({c, r});
  for (const Level level : all_levels) corrected_[level].resize(m.coordinates());
  std::mt19937 bits;
  for (double& sign : signs_.reshaped()) sign = bits() >> 31 ? -1 : 1;
}

Assessment Assessor::operator()(const Instant& instant, const Scales& scales) {
  Assessment a;
  motion_.take(instant);
  std::ranges::copy(instant.q, state_.begin());
  if (!system_.factor(state_)) {
    a.condition = INFINITY;
    return undetermined(a, system_.singular_group());
  }
  if (system_.size() > 0) {
    const WorstCase worst = of_system_(system_, system_.unknown_shares(), system_.row_shares());
    a.condition = worst.value;
    a.group = motion_.group(system_.unknowns()[worst.unknown]);
  }

  equations_of(Level::position);
  const Bound position = of_outputs(Level::position, scales);
  a.rounding = position.rounding;
  a.per_residual = of_residuals();
  enclose(Level::position);
  widen(Level::position, 2);
  const double closeness = contraction();  // η
  if (!(closeness < 0.5)) return undetermined(a, a.group);
  const double share = 1 / (1 - closeness);
  a.bound.position = share * position.whole;
  widen(Level::position, share);
  if (instant.qd.empty()) return a;

  equations_of(Level::velocity);
  a.bound.velocity = share * of_outputs(Level::velocity, scales).whole;
  enclose(Level::velocity);
  widen(Level::velocity, share);
  if (instant.qdd.empty()) return a;

  equations_of(Level::acceleration);
  a.bound.acceleration = share * of_outputs(Level::acceleration, scales).whole;
  return a;
}

Limit Assessor::limit(const Instant& instant, const Scales& scales, const Assessment& a) {
  constexpr double near_singular = 1e3;  // condition number of a block, in its own lengths, …
  constexpr double not_far = 30;         // … where there is no other cause
  constexpr double late = 0x1p-47;       // rounding of drivers, relative to their scale
  constexpr double far = 100;            // times the size
  constexpr double share = 0.1;          // of a bound, that tells where it comes from
  constexpr double no_digit = 1e-3;      // error that leaves nothing to bound
  double longest = 0, shortest = INFINITY;
  for (const int i : system_.unknowns())
    if (is_length(motion_.kind(i))) {
      longest = std::max(longest, system_.magnitude(i));
      shortest = std::min(shortest, system_.magnitude(i));
    }
  const double spread = std::max(1.0, longest / shortest);  // which no position is to blame for
  weights_.setOnes();
  change_.setOnes();
  double own = 1, worst = 0;
  if (system_.size() > 0) {
    IrreducibleBlocks blocks{system_};
    worst = of_change_(blocks, weights_, system_.block_row_sums()).value;
    if (worst > near_singular) return Limit::singular_position;
    own = of_change_(system_, weights_, change_).value;
  }
  motion_.take(instant);
  for (const Level level : all_levels) {
    const double rounding = motion_.of_drivers(level, scales);
    const double to_explain = std::min(no_digit, share * a.bound[level]);
    if (rounding > late && to_explain > 0 && a.condition * rounding > to_explain)
      return Limit::drivers;
  }
  for (const Entity& e : model_.entities)
    if (!e.fixed && e.kind == EntityKind::point)
      for (int i = e.first; i < e.first + e.size; ++i)
        if (std::abs(instant.q[i]) > far * nominal_size(model_)) return Limit::origin;
  if (std::max(spread, a.condition / own) > far) return Limit::sizes;
  return worst > not_far ? Limit::singular_position : Limit::rounding;
}

/// off_ = what that order of the equations is off by, over R, and unknown_ = how much more or less
/// it may be, for all lower orders in question.
void Assessor::equations_of(Level level) {
  const auto put = [&](int row, const Rounded& phi) {
    off_[row] = phi.value / system_.row_sums()[row];
    unknown_[row] = phi.radius / system_.row_sums()[row];
  };
  if (level == Level::position) {
    system_.equations().residual<Rounded>(motion_.positions(), phi_);
    for (int r = 0; r < system_.size(); ++r) put(r, phi_[r]);
    return;
  }
  system_.equations().residual<Jet<Rounded>>(motion_.state(), phi_motion_);
  for (int r = 0; r < system_.size(); ++r)
    put(r, row_levels_[r] >= level ? phi_motion_[r].*order_of<Rounded>(level) : Rounded());
}

/// max |A⁻¹ off_| + max |A⁻¹| unknown_ over all outputs, each relative to its scale, and the
/// drivers' own errors; the second alone. off_ = A⁻¹ off_.
Assessor::Bound Assessor::of_outputs(Level level, const Scales& scales) {
  double known = 0;
  if (system_.size() > 0) {
    system_.solve(off_.data());
    for (int j = 0; j < system_.size(); ++j) {
      const int i = system_.unknowns()[j];
      const double scale = motion_.scale(i, level, scales);
      weights_[j] = scale > 0 && asked_[i] >= level
                        ? system_.magnitude(i) * std::sqrt(motion_.size_of_output(i)) / scale
                        : 0;
    }
    known = (weights_ * off_.abs()).maxCoeff<Eigen::PropagateNaN>();
  }
  const double rounding = missed * to_outputs_[level](system_, weights_, unknown_).value;
  const double drivers = motion_.of_drivers(level, scales);
  return {std::max(known + rounding, drivers), std::max(rounding, drivers)};
}

/// max |A⁻¹ R⁻¹ Φ| over all outputs, each relative to its scale (weights_), of equations that are
/// off by their magnitudes at most, in the Euclidean norm.
double Assessor::of_residuals() {
  constexpr double margin = 2;  // another unknown may have more
  if (system_.size() == 0) return 0;
  change_ = row_magnitudes_ / system_.row_sums();
  const int worst = of_residuals_(system_, weights_, change_).unknown;
  row_.setZero();
  row_[worst] = weights_[worst];
  system_.solve_transposed(row_.data());
  return margin * (row_ * change_).matrix().norm();
}

/// error_ ≥ |off_| + |A⁻¹| unknown_, the same for all unknowns of a group: of the second, what
/// signs without a pattern show of each, and as many times that as it takes.
void Assessor::enclose(Level level) {
  std::ranges::fill(max_, 0.0);
  std::ranges::fill(max_length_, 0.0);
  if (system_.size() > 0) {
    probes_ = signs_.colwise() * unknown_;
    system_.solve(probes_.data(), static_cast<int>(probes_.cols()));
    for (const auto& probe : probes_.colwise()) at_least(probe);
  }
  for (int j = 0; j < system_.size(); ++j) error_[j] = of_group(j);
  error_ *= missed * to_errors_[level](system_, inverse(error_), unknown_).value;
  std::ranges::fill(max_, 0.0);
  std::ranges::fill(max_length_, 0.0);
  at_least(off_);
  for (int j = 0; j < system_.size(); ++j) error_[j] += of_group(j);
}

void Assessor::at_least(const Eigen::Ref<const Eigen::ArrayXd>& errors) {
  for (int j = 0; j < system_.size(); ++j)
    max_[group_[j]] = std::max(max_[group_[j]], std::abs(errors[j]));
  for (int j = 0; j < system_.size(); ++j)
    if (const int i = system_.unknowns()[j]; is_length(motion_.kind(i)))
      max_length_[group_[j]] =
          std::max(max_length_[group_[j]], std::abs(errors[j]) * system_.magnitude(i));
}

/// Returns the largest error in the group of an unknown. That of a small body counts in lengths
/// where a large one is next to it.
double Assessor::of_group(int unknown) const {
  constexpr double large = 100;
  const int i = system_.unknowns()[unknown];
  const double error = max_[group_[unknown]];
  if (!is_length(motion_.kind(i)) || system_.norm() == Norm::of_whole) return error;
  return std::min(error, large * max_length_[group_[unknown]] / system_.magnitude(i));
}

/// 1 / errors; 0 of what is exact.
const Eigen::ArrayXd& Assessor::inverse(const Eigen::ArrayXd& errors) {
  weights_ = (errors > 0).select(errors.inverse(), 0);
  return weights_;
}

/// By how much Φ_φ changes at most within the errors of position, against itself, in the norm in
/// which these are equal.
double Assessor::contraction() {
  change_.setZero();
  system_.equations().jacobian<Rounded>(
      motion_.positions(), [&](int row, int i, const Rounded& value) {
        if (system_.is_unknown(i))
          change_[row] += value.radius * system_.magnitude(i) * error_[system_.column(i)];
      });
  change_ /= system_.row_sums();
  return of_change_(system_, inverse(error_), change_).value;
}

/// Unknowns may be wrong by so many times their errors.
void Assessor::widen(Level level, double times) {
  for (int j = 0; j < system_.size(); ++j)
    change_[j] = times * error_[j] * system_.magnitude(system_.unknowns()[j]);
  motion_.widen(level, system_.unknowns(), change_);
}

}  // namespace desmo
