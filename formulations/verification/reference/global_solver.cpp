#include "formulations/verification/reference/global_solver.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "formulations/constraints/jet.h"
#include "formulations/motion/groupwise/stopping_rule.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo {

template <class S>
void GlobalSolver<S>::set_homotopy(double share) {
  if (initial_.empty()) {
    initial_.resize(system().rows());
    system().template residual<S>(state_.q, initial_);
  }
  share_ = share;
}

template <class S>
double GlobalSolver<S>::correct_positions() {
  factor();
  std::vector<S> phi(system().rows());
  system().template residual<S>(state_.q, phi);
  if (share_ != 0)
    for (std::size_t r = 0; r < phi.size(); ++r) phi[r] -= share_ * initial_[r];
  return correct(phi, state_.q);
}

template <class S>
void GlobalSolver<S>::solve_positions(double t) {
  time_ = t;
  this->drive_to(t);
  StoppingRule<S> stops_after;
  for (int iteration = 0; iteration < stops_after.max_corrections; ++iteration)
    if (stops_after(correct_positions())) return;
  throw std::runtime_error(m_.name + ": no global reference solution at t = " + std::to_string(t) +
                           " s");
}

template <class S>
void GlobalSolver<S>::solve_rates() {
  factor();
  for (const int i : system().unknowns()) state_.qd[i] = state_.qdd[i] = S(0);
  std::vector<Jet<S>> state(state_.q.size()), phi(system().rows());
  std::vector<S> residual(phi.size());
  // Corrections shrink until only rounding is left.
  const auto refine = [&](S Jet<S>::*order, std::vector<S>& values) {
    for (double last = INFINITY, correction = 0;; last = correction) {
      for (std::size_t i = 0; i < state.size(); ++i)
        state[i] = {state_.q[i], state_.qd[i], state_.qdd[i]};
      system().template residual<Jet<S>>(state, phi);  // Φ, Φ̇ and Φ̈
      std::ranges::transform(phi, residual.data(), order);
      correction = correct(residual, values);
      if (!(correction < last / 2)) return;
    }
  };
  refine(&Jet<S>::first, state_.qd);
  refine(&Jet<S>::second, state_.qdd);
}

/// Factorises Φ_φ at the present positions.
template <class S>
void GlobalSolver<S>::factor() {
  const std::vector<double> q(state_.q.begin(), state_.q.end());
  if (!factors_.factor(q))
    throw std::runtime_error(m_.name + ": singular global matrix at t = " + std::to_string(time_) +
                             " s");
}

/// Subtracts Φ_φ⁻¹ times the residual from the unknowns' positions, or from one of their rates.
/// Returns the largest correction relative to the nominal magnitude of its coordinate.
template <class S>
double GlobalSolver<S>::correct(std::span<const S> residual, std::vector<S>& values) {
  std::vector<double> step(residual.begin(), residual.end());
  factors_.solve_unscaled(step);
  return this->subtract(std::vector<S>(step.begin(), step.end()), system().unknowns(), values);
}

template class GlobalSolver<Quadruple>;
// The double one only follows the motion, for which positions are enough.
template void GlobalSolver<double>::set_homotopy(double);
template double GlobalSolver<double>::correct_positions();
template void GlobalSolver<double>::solve_positions(double);

}  // namespace desmo
