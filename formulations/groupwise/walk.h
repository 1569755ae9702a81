#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace desmo {

/// Goes from an assembly at the first of the times [s] to each in turn, no step longer than 10 ms.
/// Calls step(t) to follow the motion, and arrive(t) after the steps that lead to one of the times.
template <class Step, class Arrive>
void walk(std::span<const double> times, Step&& step, Arrive&& arrive) {
  constexpr double max_step = 0.01;
  double t = times.empty() ? 0 : times.front();
  for (const double target : times) {
    const int steps = std::max(1, static_cast<int>(std::ceil((target - t) / max_step - 1e-9)));
    const double from = t;
    for (int i = 1; i <= steps; ++i) step(i == steps ? target : from + (target - from) * i / steps);
    arrive(t = target);
  }
}

}  // namespace desmo
