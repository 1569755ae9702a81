#pragma once

#include <array>
#include <chrono>
#include <utility>

#include "formulations/equations/pattern.h"

namespace desmo {

/// What a step spends its time on.
enum class Phase { residual, jacobian, factorisation, solve, right_hand_sides };
inline constexpr int phase_count = 5;

/// Accumulated time and calls of each phase, of all parts of one formulation.
struct Profile {
  std::array<double, phase_count> seconds{};  ///< includes the cost of reading the clock
  std::array<long, phase_count> calls{};

  /// Runs f and adds its time to a phase.
  template <class F>
  auto measure(Phase phase, F&& f) {
    const auto start = std::chrono::steady_clock::now();
    struct Stop {
      Profile& profile;
      int phase;
      std::chrono::steady_clock::time_point start;
      ~Stop() {
        const std::chrono::duration<double> d = std::chrono::steady_clock::now() - start;
        profile.seconds[phase] += d.count();
        ++profile.calls[phase];
      }
    } stop{*this, static_cast<int>(phase), start};
    return f();
  }
};

/// Equations whose evaluations are measured; the same contract as what they wrap, so that no
/// solver has a timer inside.
template <class Equations>
class ProfiledEquations {
 public:
  using Real = typename Equations::Real;

  ProfiledEquations(Equations equations, Profile& profile)
      : equations_(std::move(equations)), profile_(&profile) {}

  const Pattern& pattern() const { return equations_.pattern(); }
  void constant_jacobian(Real* values) const { equations_.constant_jacobian(values); }
  void residual(const Real* q, Real* phi) const {
    profile_->measure(Phase::residual, [&] { equations_.residual(q, phi); });
  }
  void jacobian(const Real* q, Real* values) const {
    profile_->measure(Phase::jacobian, [&] { equations_.jacobian(q, values); });
  }
  void known_jacobian(const Real* q, Real* values) const {
    profile_->measure(Phase::right_hand_sides, [&] { equations_.known_jacobian(q, values); });
  }
  void quadratic(const Real* q, const Real* qd, Real* gamma) const {
    profile_->measure(Phase::right_hand_sides, [&] { equations_.quadratic(q, qd, gamma); });
  }

 private:
  Equations equations_;
  Profile* profile_;
};

/// Linear algebra whose factorisations and solutions are measured.
template <class Algebra>
class ProfiledAlgebra {
 public:
  static constexpr bool rounds_factors = Algebra::rounds_factors;
  static constexpr bool keeps_pivots = Algebra::keeps_pivots;

  ProfiledAlgebra(const Pattern& pattern, Profile& profile)
      : algebra_(pattern), profile_(&profile) {}

  template <class Real>
  bool factor(const Real* values) {
    return profile_->measure(Phase::factorisation, [&] { return algebra_.factor(values); });
  }
  template <class Real>
  void solve(Real* b) {
    profile_->measure(Phase::solve, [&] { algebra_.solve(b); });
  }
  int patience() const { return algebra_.patience(); }
  void forget_pivots() { algebra_.forget_pivots(); }
  long pivotings() const { return algebra_.pivotings(); }

 private:
  Algebra algebra_;
  Profile* profile_;
};

}  // namespace desmo
