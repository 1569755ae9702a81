#include "formulations/verification/assessment/nominal_continuation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "formulations/scaling/characteristic_lengths.h"
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
/// Of the distance to another position, how far an estimate may be off.
constexpr double estimate_share = 0.4;
/// Blocks of so few unknowns have two positions at most, a link apart.
constexpr int two_fold = 3;
/// First and shortest step, of the whole way; steps tried at most.
constexpr double first_step = 1, min_step = 0x1p-44;
constexpr int max_tries = 5000;

}  // namespace

NominalContinuation::NominalContinuation(const Model& m, Assessor& assessor)
    : model_(m),
      assessor_(assessor),
      magnitude_(assessor.system().magnitudes().begin(), assessor.system().magnitudes().end()),
      state_(m.state_size()) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
}

/// Solves q, and q̇ along the way with drivers that have moved and move. Returns whether it can.
bool NominalContinuation::solve(State& to, double step) {
  const Instant from{.index = 0, .time = step, .q = to.q, .qd = to.qd, .qdd = {}};
  const Instant found = assessor_.corrected(from);
  to.q.assign(found.q.begin(), found.q.end());
  to.qd.assign(found.qd.begin(), found.qd.end());
  return std::ranges::all_of(to.q, [](double x) { return std::isfinite(x); }) &&
         std::ranges::all_of(to.qd, [](double x) { return std::isfinite(x); });
}

bool NominalContinuation::begin() {
  ScaledSystem& system = assessor_.system();
  nominal_.q = model_.estimate;
  nominal_.qd.assign(nominal_.q.size(), 0);
  nominal_.qdd.clear();
  std::ranges::copy(nominal_.q, state_.begin());
  if (!system.factor(state_)) return false;
  const std::vector<signed char> declared(system.orientation().begin(), system.orientation().end());
  if (!solve(nominal_, 0)) return false;
  const std::vector<double> before = nominal_.q;
  if (!solve(nominal_, 0)) return false;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!(std::abs(nominal_.q[i] - before[i]) <= last_correction * magnitude_[i])) return false;
  std::ranges::copy(nominal_.q, state_.begin());
  if (!system.factor(state_)) return false;
  signs_.assign(system.orientation().begin(), system.orientation().end());
  if (signs_ != declared) return false;
  const double condition = this->condition();
  const std::vector<double> lengths = CharacteristicLengths(model_, nominal_.q).of_coordinates();
  for (int j = 0; j < system.size(); ++j) {
    const int i = system.unknowns()[j];
    if (system.block_size(j) == 1) continue;  // signs decide
    const double nearest = system.block_size(j) <= two_fold ? 1 : 1 / condition;
    if (std::abs(nominal_.q[i] - model_.estimate[i]) > estimate_share * nearest * lengths[i])
      return false;
  }
  return true;
}

bool NominalContinuation::go_to(const Instant& instant) {
  std::vector<double> near_way, whole;
  for (const Driver& d : model_.drivers) {
    const Entity& driven = model_.entities[d.coordinate];
    whole.push_back(instant.q[driven.first] - nominal_.q[driven.first]);
    near_way.push_back(driven.kind == EntityKind::angle
                           ? std::remainder(whole.back(), 2 * std::numbers::pi)
                           : whole.back());
  }
  turns_ = near_way != whole;
  if (!go(near_way) && (!turns_ || !go(whole))) return false;
  for (const Driver& d : model_.drivers) {
    const int i = model_.entities[d.coordinate].first;
    reached_.q[i] = instant.q[i];
  }
  return true;
}

/// Moves the drivers by these changes from the nominal position.
bool NominalContinuation::go(std::span<const double> changes) {
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
  if (!solve(next_, 0) || !keeps_branch()) return false;
  reached_ = next_;
  double done = 0, step = first_step;
  for (int i = 0; i < max_tries && done < 1; ++i) {
    step = std::min(step, 1 - done);
    const double to = step < 1 - done ? done + step : 1;
    next_ = reached_;
    for (std::size_t k = 0; k < next_.q.size(); ++k) next_.q[k] += step * reached_.qd[k];
    drive(next_, to);
    const std::vector<double> before = determinants_;
    if (solve(next_, to) && leads_on(step) && keeps_branch()) {
      std::swap(reached_, next_);
      done = to;
      step *= 2;
    } else {
      determinants_ = before;
      if ((step /= 2) < min_step) return false;
    }
  }
  return done >= 1;
}

bool NominalContinuation::leads_to(std::span<const double> q) {
  constexpr double same = 0.1;  // of the distance to another position
  const double allowed = same / condition();
  for (const Entity& e : model_.entities) {
    if (e.fixed) continue;
    for (int i = e.first; i < e.first + e.size; ++i) {
      double off = q[i] - reached_.q[i];
      if (turns_ && e.kind == EntityKind::angle) off = std::remainder(off, 2 * std::numbers::pi);
      if (!(std::abs(off) <= allowed * magnitude_[i])) return false;
    }
  }
  return true;
}

/// Returns the condition number at the position factorised last.
double NominalContinuation::condition() {
  ScaledSystem& system = assessor_.system();
  return InverseNorm(system.size())(system, system.unknown_shares(), system.row_shares()).value;
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
  ScaledSystem& system = assessor_.system();
  std::ranges::copy(next_.q, state_.begin());
  if (!system.factor(state_) || !std::ranges::equal(system.orientation(), signs_)) return false;
  std::vector<double> now(signs_.size());
  for (std::size_t b = 0; b < now.size(); ++b) now[b] = system.log_determinant(static_cast<int>(b));
  const bool is_first = determinants_.empty();
  for (std::size_t b = 0; b < now.size() && !is_first; ++b)
    if (!(std::abs(now[b] - determinants_[b]) < std::log(max_change))) return false;
  determinants_ = std::move(now);
  return true;
}

}  // namespace desmo
