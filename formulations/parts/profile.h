#pragma once

#include <array>
#include <chrono>

namespace desmo {

/// Phases that a step spends its time on.
enum class Phase { residual, jacobian, factorisation, solve, right_hand_sides };
inline constexpr int phase_count = 5;

/// Accumulated time and number of calls of each phase, over all parts of one formulation.
struct Profile {
  std::array<double, phase_count> seconds{};  ///< [s], including reading the clock
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

}  // namespace desmo
