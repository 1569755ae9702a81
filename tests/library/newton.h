#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "tests/library/jet.h"

namespace desmo::exact {

/// Solves A X = B by elimination with row exchanges; B becomes X.
template <std::size_t N, std::size_t M>
void eliminate(std::array<std::array<Real, N>, N> a, std::array<std::array<Real, M>, N>& b) {
  for (std::size_t k = 0; k < N; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < N; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = 0; i < N; ++i) {
      if (i == k) continue;
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < N; ++j) a[i][j] -= factor * a[k][j];
      for (std::size_t j = 0; j < M; ++j) b[i][j] -= factor * b[k][j];
    }
  }
  for (std::size_t i = 0; i < N; ++i)
    for (Real& x : b[i]) x /= a[i][i];
}

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
    std::array<std::array<Real, N>, N> jacobian;
    for (std::size_t k = 0; k < N; ++k) {
      Jets moving = still;
      moving[k].d = 1;
      const Jets response = f(moving);
      for (std::size_t i = 0; i < N; ++i) jacobian[i][k] = response[i].d - own[i].d;
    }

    const Jets residual = f(x);
    std::array<std::array<Real, 3>, N> step;
    for (std::size_t i = 0; i < N; ++i) step[i] = {residual[i].v, residual[i].d, residual[i].dd};
    eliminate(jacobian, step);
    Real largest = 0;
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = x[i] - Jet(step[i][0], step[i][1], step[i][2]);
      largest = std::max(largest, std::abs(step[i][0]));
    }
    if (largest < settled && --more == 0) return x;
  }
  throw std::runtime_error("an independent solution did not converge");
}

}  // namespace desmo::exact
