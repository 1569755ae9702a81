#pragma once

#include <span>
#include <vector>

#include "cases/mechanism.h"

namespace desmo {

/// A solved instant in coordinate order, rounded to double, fixed entities left out.
struct ReferenceInstant {
  double time;  ///< s
  std::vector<double> q, qd, qdd;
};

enum class Precision { standard, quadruple };

/// Positions, velocities and accelerations at ascending instants, found group by group with code
/// that shares with the formulations only the constraint kinds, the motions and the list of parts:
/// dense matrices, pivoting, Newton's method, steps of at most 10 ms from an assembly at
/// times.front(). With quadruple precision, each instant is then solved again in that precision to
/// ‖Φ‖₂ < 1e-28 a group, ten decimal digits beyond what double resolves. Throws std::runtime_error,
/// naming the group and the instant, when it does not converge.
std::vector<ReferenceInstant> reference_solution(const Mechanism& mechanism,
                                                 std::span<const double> times,
                                                 Precision precision);

}  // namespace desmo
