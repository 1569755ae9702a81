#include "formulations/verification/assessment/nominal_continuation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "formulations/verification/assessment/inverse_norm.h"

namespace desmo {

namespace {

/// By how much of a step's movement the trapezoid rule may be off.
constexpr double bend = 0.02;
/// Movement in magnitudes that rounding may feign.
constexpr double feigned = 1e-12;
/// Largest change of a determinant in a step, as a factor.
constexpr double max_change = 5;
/// Last correction, in magnitudes, of a nominal position that counts as solved.
constexpr double last_correction = 1e-6;
/// Correction, in magnitudes, after which the factors serve once more, and corrections at most.
constexpr double near_solution = 1e-8;
constexpr int max_corrections = 20;
/// Of the distance to another position, how far an estimate may be off.
constexpr double estimate_share = 0.4;
/// Blocks of so few unknowns have two positions at most, a link apart.
constexpr int two_fold = 3;
/// Condition number of a block, in its own lengths, up to which its branch is known.
constexpr double max_condition = 1e6;
/// First and shortest step, of the whole way; steps tried at most.
constexpr double first_step = 1, min_step = 0x1p-44;
constexpr int max_tries = 5000;
constexpr double turn = 2 * std::numbers::pi;
/// Way of a driven angle up to which its whole turns are gone, too [rad].
constexpr double few_turns = 4 * turn;

}  // namespace

NominalContinuation::NominalContinuation(const Model& m, ScaledSystem& system)
    : model_(m),
      system_(system),
      magnitude_(system.magnitudes().begin(), system.magnitudes().end()),
      state_(m.state_size()),
      off_(system.size()) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
}

/// Solves q with drivers that have moved. Returns whether it can. is_factorised: there are factors
/// for q. Leaves factors that are off q by so little that signs and determinants are its own.
bool NominalContinuation::solve(std::span<double> q, bool is_factorised) {
  double before = INFINITY;
  for (int i = 0; i < max_corrections; ++i) {
    std::ranges::copy(q, state_.begin());
    if (!(is_factorised && i == 0) && !system_.factor(state_)) return false;
    last_correction_ = correct(q);
    if (last_correction_ <= near_solution) last_correction_ = correct(q);
    if (!(last_correction_ < before / 2) || last_correction_ <= near_solution) break;
    before = last_correction_;
  }
  return std::ranges::all_of(q, [](double x) { return std::isfinite(x); });
}

/// Corrects q by the factors at hand. Returns the largest correction, in magnitudes.
double NominalContinuation::correct(std::span<double> q) {
  if (system_.size() == 0) return 0;
  std::ranges::copy(q, state_.begin());
  system_.equations().residual<double>(state_,
                                       {off_.data(), static_cast<std::size_t>(off_.size())});
  off_ /= system_.row_sums();
  system_.solve(off_.data());
  for (int j = 0; j < system_.size(); ++j) {
    const int i = system_.unknowns()[j];
    q[i] -= magnitude_[i] * off_[j];
  }
  return off_.abs().maxCoeff<Eigen::PropagateNaN>();
}

/// Solves q̇ along the way from the drivers', at the position solved last. Returns whether it can.
bool NominalContinuation::solve_rates(std::span<double> qd) {
  if (system_.size() == 0) return true;
  off_.setZero();
  system_.equations().jacobian<double>(state_, [&](int row, int i, double value) {
    if (!system_.is_unknown(i) && i < model_.coordinates()) off_[row] += value * qd[i];
  });
  off_ /= system_.row_sums();
  system_.solve(off_.data());
  for (int j = 0; j < system_.size(); ++j) {
    const int i = system_.unknowns()[j];
    qd[i] = -magnitude_[i] * off_[j];
  }
  return std::isfinite(off_.abs().maxCoeff<Eigen::PropagateNaN>());
}

bool NominalContinuation::begin() {
  nominal_.q = model_.estimate;
  nominal_.qd.assign(nominal_.q.size(), 0);
  nominal_.qdd.clear();
  std::ranges::copy(nominal_.q, state_.begin());
  if (!system_.factor(state_)) return false;
  const auto signs = system_.orientation();
  const std::vector<signed char> declared(signs.begin(), signs.end());
  if (!solve(nominal_.q, true) || !(last_correction_ <= last_correction)) return false;
  is_at_nominal_ = true;
  signs_.assign(signs.begin(), signs.end());
  if (signs_ != declared) return false;
  std::optional<double> nearest_of_many;
  const std::vector<double> lengths = system_.magnitudes_at(nominal_.q);
  for (int j = 0; j < system_.size(); ++j) {
    const int i = system_.unknowns()[j];
    if (system_.block_size(j) == 1) continue;  // signs decide
    const bool is_two_fold = system_.block_size(j) <= two_fold;
    if (!is_two_fold && !nearest_of_many) nearest_of_many = 1 / condition();
    const double nearest = is_two_fold ? 1 : *nearest_of_many;
    if (std::abs(nominal_.q[i] - model_.estimate[i]) > estimate_share * nearest * lengths[i])
      return false;
  }
  return true;
}

bool NominalContinuation::begin_at(std::span<const double> q) {
  is_followed_closely_ = true;
  nominal_.q.assign(q.begin(), q.end());
  nominal_.qd.assign(q.size(), 0);
  nominal_.qdd.clear();
  std::ranges::copy(q, state_.begin());
  if (!system_.factor(state_)) return false;
  signs_.assign(system_.orientation().begin(), system_.orientation().end());
  own_condition_ = own_condition();
  return own_condition_ <= max_condition;
}

bool NominalContinuation::go_to(const Instant& instant) {
  std::vector<double> near_way, whole;
  double longest = 0;  // of angles
  for (const Driver& d : model_.drivers) {
    const Entity& driven = model_.entities[d.coordinate];
    whole.push_back(instant.q[driven.first] - nominal_.q[driven.first]);
    near_way.push_back(whole.back());
    if (driven.kind != EntityKind::angle) continue;
    near_way.back() = std::remainder(whole.back(), turn);
    longest = std::max(longest, std::abs(whole.back()));
  }
  const bool has_turns = near_way != whole;
  const bool has_guess = !has_turns && !is_followed_closely_;
  const std::span<const double> guess = has_guess ? instant.q : std::span<const double>();
  const bool reaches = longest <= few_turns && go(whole, guess);
  turns_ = has_turns && !reaches;
  if (!reaches && !(has_turns && go(near_way, {}))) return false;
  for (const Driver& d : model_.drivers) {
    const int i = model_.entities[d.coordinate].first;
    reached_.q[i] = instant.q[i];
  }
  return true;
}

/// Moves the drivers by these changes from the nominal position. guess: where that may lead.
bool NominalContinuation::go(std::span<const double> changes, std::span<const double> guess) {
  const auto drive = [&](State& state, double part) {
    for (std::size_t d = 0; d < changes.size(); ++d) {
      const int i = model_.entities[model_.drivers[d].coordinate].first;
      state.q[i] = nominal_.q[i] + part * changes[d];
      state.qd[i] = changes[d];
    }
  };
  determinants_.clear();
  next_ = nominal_;
  drive(next_, 0);
  std::ranges::copy(next_.q, state_.begin());
  if (!is_at_nominal_ && !solve(next_.q)) return false;
  if (!solve_rates(next_.qd) || !keeps_branch()) return false;
  is_at_nominal_ = false;
  reached_ = next_;
  if (std::ranges::all_of(changes, [](double change) { return change == 0; })) return true;
  if (!guess.empty()) {
    next_.q.assign(guess.begin(), guess.end());
    drive(next_, 1);
    if (arrives(1)) return true;
  }
  double done = 0, step = first_step;
  for (int i = 0; i < max_tries && done < 1; ++i) {
    step = std::min(step, 1 - done);
    const double to = step < 1 - done ? done + step : 1;
    next_ = reached_;
    for (std::size_t k = 0; k < next_.q.size(); ++k) next_.q[k] += step * reached_.qd[k];
    drive(next_, to);
    if (arrives(step)) {
      done = to;
      step *= 2;
    } else if ((step /= 2) < min_step) {
      return false;
    }
  }
  return done >= 1;
}

/// Solves next_, and makes it the position reached if a step leads there.
bool NominalContinuation::arrives(double step) {
  const std::vector<double> before = determinants_, predicted = next_.q;
  if (solve(next_.q) && solve_rates(next_.qd) && leads_on(step) && keeps_branch() &&
      (!is_followed_closely_ || is_close(predicted))) {
    std::swap(reached_, next_);
    return true;
  }
  determinants_ = before;
  return false;
}

bool NominalContinuation::leads_to(std::span<const double> q) {
  constexpr double same = 0.1;  // of the distance to another position
  constexpr double equal = 1e-12;
  const double off = farthest(q);
  return off <= equal || off <= same / condition();
}

/// Returns how far these positions are off the ones reached at most, in magnitudes.
double NominalContinuation::farthest(std::span<const double> q) const {
  double most = 0;
  for (const Entity& e : model_.entities) {
    if (e.fixed) continue;
    for (int i = e.first; i < e.first + e.size; ++i) {
      double off = q[i] - reached_.q[i];
      if (turns_ && e.kind == EntityKind::angle) off = std::remainder(off, turn);
      if (!std::isfinite(off)) return INFINITY;
      most = std::max(most, std::abs(off) / magnitude_[i]);
    }
  }
  return most;
}

/// Returns the condition number at the position factorised last.
double NominalContinuation::condition() {
  return InverseNorm(system_.size())(system_, system_.unknown_shares(), system_.row_shares()).value;
}

/// Returns the worst condition number of a block at the position factorised last, in its own
/// lengths: about the inverse of the distance to a singular position.
double NominalContinuation::own_condition() {
  const Eigen::ArrayXd ones = Eigen::ArrayXd::Ones(system_.size());
  IrreducibleBlocks blocks{system_};
  if (system_.size() == 0) return 1;
  return InverseNorm(system_.size())(blocks, ones, system_.block_row_sums()).value;
}

/// Returns whether the position solved last is near its prediction, compared with the distances of
/// both ends of the step to a singular position.
bool NominalContinuation::is_close(std::span<const double> predicted) {
  constexpr double share = 0.1;
  double off = 0;
  for (std::size_t i = 0; i < predicted.size(); ++i)
    off = std::max(off, std::abs(next_.q[i] - predicted[i]) / magnitude_[i]);
  const double before = own_condition_, now = own_condition();
  // Nearer to a singular position rounding hides which branch a step leads to.
  if (!(now <= max_condition) || !(off * std::max(before, now) <= share)) return false;
  own_condition_ = now;
  return true;
}

/// Returns whether the rates at both ends lead from one to the other.
bool NominalContinuation::leads_on(double step) const {
  double moved = 0, off = 0;
  for (std::size_t i = 0; i < next_.q.size(); ++i) {
    const double change = next_.q[i] - reached_.q[i],
                 expected = step / 2 * (next_.qd[i] + reached_.qd[i]);
    moved = std::max(moved, std::abs(change) / magnitude_[i]);
    off = std::max(off, std::abs(change - expected) / magnitude_[i]);
  }
  return off <= bend * moved + feigned;
}

/// Returns whether all determinants keep their signs, and hardly change since the last step.
bool NominalContinuation::keeps_branch() {
  if (!std::ranges::equal(system_.orientation(), signs_)) return false;
  std::vector<double> now(signs_.size());
  for (std::size_t b = 0; b < now.size(); ++b)
    now[b] = system_.log_determinant(static_cast<int>(b));
  const bool is_first = determinants_.empty();
  for (std::size_t b = 0; b < now.size() && !is_first; ++b)
    if (!(std::abs(now[b] - determinants_[b]) < std::log(max_change))) return false;
  determinants_ = std::move(now);
  return true;
}

}  // namespace desmo
