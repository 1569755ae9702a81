#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"

namespace desmo {

/// Solves a motion at ascending instants [s] in double precision, group by group with dense
/// matrices, on the branch of the drawing (DrawnStart). This is reference_solution() with
/// Precision::standard, for programs without quadruple precision. Throws std::runtime_error, naming
/// the group and the instant, when Newton's method does not converge.
std::vector<ReferenceInstant> double_solution(const Model& model, std::span<const double> times);

/// Steps from an assembly at times.front() [s] to each time in turn, in steps of at most 10 ms.
/// Calls step(t) to follow the motion, and arrive(t) at each of the times.
template <class Step, class Arrive>
void follow_motion(std::span<const double> times, Step&& step, Arrive&& arrive) {
  constexpr double max_step = 0.01;  // [s]
  double t = times.empty() ? 0 : times.front();
  for (const double target : times) {
    const int steps = std::max(1, static_cast<int>(std::ceil((target - t) / max_step - 1e-9)));
    const double from = t;
    for (int i = 1; i <= steps; ++i) step(i == steps ? target : from + (target - from) * i / steps);
    arrive(t = target);
  }
}

}  // namespace desmo
