#include "tests/properties/assembled_drawing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formulations/verification/reference/global_solver.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo::properties {

namespace {

constexpr double max_first_correction = 0.01;  // first correction of a step, over magnitudes, <
constexpr double solved = 1e-28;               // correction that only rounding leaves, likewise, <
constexpr double min_step = 1e-6;              // step of λ, >

/// Returns the largest of Newton's corrections over nominal magnitudes; infinite: the matrix is
/// singular.
double corrected(GlobalSolver<Quadruple>& solver) {
  try {
    return solver.correct_positions();
  } catch (const std::runtime_error&) {
    return INFINITY;
  }
}

/// Solves Φ(q) = (1 − λ) Φ(drawing) by Newton's method, which has to contract at once.
bool solve(GlobalSolver<Quadruple>& solver, double lambda) {
  solver.set_homotopy(1 - lambda);
  double last = INFINITY;
  for (int i = 0; i < 30; ++i) {
    const double correction = corrected(solver);
    if (correction < solved) return true;
    if (!(correction < (i == 0 ? max_first_correction : last / 2))) return last < 1e-20;
    last = correction;
  }
  return last < 1e-20;
}

/// Goes from λ = 0, the drawing, to 1. Returns whether it could. λ is a sum of powers of two, which
/// a double holds.
bool follow(GlobalSolver<Quadruple>& solver) {
  double lambda = 0, step = 1. / 16;
  while (lambda < 1 && step > min_step) {
    const double next = std::min(1., lambda + step);
    const ScalarState<Quadruple> before = solver.state();
    if (solve(solver, next)) {
      lambda = next;
      step *= 2;
    } else {
      solver.restore(before);
      step /= 2;
    }
  }
  return lambda == 1;
}

}  // namespace

Model with_assembled_drawing(Model m) {
  GlobalSolver<Quadruple> solver(m);
  if (!follow(solver)) throw std::runtime_error(m.name + ": the drawing means no position");
  for (int i = 0; i < m.coordinates(); ++i)
    m.estimate[i] = static_cast<double>(solver.state().q[i]);
  return m;
}

}  // namespace desmo::properties
