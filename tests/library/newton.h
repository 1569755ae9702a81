#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "tests/library/jet.h"

namespace desmo::exact {

/// Solves f(x) = 0 for the values and two time derivatives of x (N), starting at `start`. Newton's
/// method with the Jacobian of the values corrects all three orders at once; each order converges
/// one iteration after the lower one. Throws std::runtime_error when the values do not converge.
template <std::size_t N, class F>
std::array<Jet, N> solve(const std::array<Real, N>& start, F&& f) {
  using Jets = std::array<Jet, N>;
  constexpr int most = 40;
  constexpr Real settled = 1000 * std::numeric_limits<Real>::epsilon();
  int more = 4;  // two for the derivatives, the others against the rounding of their residuals
  Jets x;
  std::copy(start.begin(), start.end(), x.begin());
  for (int iteration = 0; iteration < most; ++iteration) {
    // Column k: the rate of f when only unknown k has the rate 1, minus the partial ∂f/∂t.
    Jets still = x;
    for (Jet& u : still) u = u.v;
    const Jets own = f(still);
    Eigen::Matrix<Real, N, N> jacobian;
    for (std::size_t k = 0; k < N; ++k) {
      Jets moving = still;
      moving[k].d = 1;
      const Jets response = f(moving);
      for (std::size_t i = 0; i < N; ++i) jacobian(i, k) = response[i].d - own[i].d;
    }

    const Jets residual = f(x);
    Eigen::Matrix<Real, N, 3> right;
    for (std::size_t i = 0; i < N; ++i)
      right.row(i) << residual[i].v, residual[i].d, residual[i].dd;
    const Eigen::Matrix<Real, N, 3> step = jacobian.partialPivLu().solve(right);
    for (std::size_t i = 0; i < N; ++i) x[i] = x[i] - Jet(step(i, 0), step(i, 1), step(i, 2));
    if (step.col(0).cwiseAbs().maxCoeff() < settled && --more == 0) return x;
  }
  throw std::runtime_error("an independent solution did not converge");
}

}  // namespace desmo::exact
