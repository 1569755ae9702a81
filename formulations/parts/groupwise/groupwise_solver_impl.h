// Definitions, instantiated once for each scalar: double_solution.cpp, and
// groupwise_quadruple.cpp of verification/reference.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/part_system.h"
#include "formulations/model/scales.h"
#include "formulations/parts/groupwise/dense_lu.h"
#include "formulations/parts/groupwise/groupwise_solver.h"
#include "formulations/parts/groupwise/settling.h"

namespace desmo {

template <class S>
GroupwiseSolver<S>::GroupwiseSolver(const Model& m)
    : m_(m),
      parts_(make_partition(m, Partition::group)),
      magnitude_(nominal_magnitudes(m)),
      state_(m.state_size()) {
  std::ranges::copy(m.estimate, state_.q.begin());
  for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
    state_.q[m.coordinates() + i] = as<S>(m.fixed_value(i));
}

template <class S>
void GroupwiseSolver<S>::solve_positions(double t) {
  for (const Driver& d : m_.drivers) {
    const int i = m_.entities[d.coordinate].first;
    const MotionSample<S> z = sample(d.motion, S(t));
    state_.q[i] = z.position;
    state_.qd[i] = z.velocity;
    state_.qdd[i] = z.acceleration;
  }
  for (std::size_t part = 0; part < parts_.size(); ++part) solve_positions(part, t);
}

template <class S>
void GroupwiseSolver<S>::drive(std::span<const S> drivers) {
  for (std::size_t k = 0; k < drivers.size(); ++k)
    state_.q[m_.entities[m_.drivers[k].coordinate].first] = drivers[k];
}

template <class S>
void GroupwiseSolver<S>::set_homotopy(double share) {
  if (initial_.empty())
    for (const PartDefinition& part : parts_)
      initial_.push_back(PartSystem<S>(m_, part, state_).phi);
  share_ = share;
}

template <class S>
double GroupwiseSolver<S>::correct_positions() {
  double largest = 0;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const double correction = correct(part);
    if (!(correction <= largest)) largest = correction;  // NaN stays
  }
  return largest;
}

template <class S>
void GroupwiseSolver<S>::solve_rates() {
  for (const PartDefinition& part : parts_) {
    const PartSystem<S> before(m_, part, state_);
    const DenseLu<S> lu(before.jacobian, before.n);
    const std::vector<S> velocity = lu.solve(before.velocity);
    for (std::size_t j = 0; j < before.n; ++j) state_.qd[part.unknowns[j]] = velocity[j];
    const PartSystem<S> after(m_, part, state_);  // Φ̇_q q̇ depends on the velocities just found
    const std::vector<S> acceleration = lu.solve(after.acceleration);
    for (std::size_t j = 0; j < after.n; ++j) state_.qdd[part.unknowns[j]] = acceleration[j];
  }
}

template <class S>
void GroupwiseSolver<S>::solve_positions(std::size_t part, double t) {
  Settling<S> settled;
  for (int iteration = 0; iteration < 50; ++iteration)
    if (settled(correct(part))) return;
  throw std::runtime_error(m_.name + ", group '" + m_.groups[parts_[part].groups.front()].name +
                           "': no reference solution at t = " + std::to_string(t) + " s");
}

/// Corrects the positions of a part once. Returns the largest correction, relative to magnitudes.
template <class S>
double GroupwiseSolver<S>::correct(std::size_t index) {
  const PartDefinition& part = parts_[index];
  PartSystem<S> system(m_, part, state_);
  if (share_ != 0)
    for (std::size_t j = 0; j < system.n; ++j) system.phi[j] -= share_ * initial_[index][j];
  const std::vector<S> step =
      DenseLu<S>(std::move(system.jacobian), system.n).solve(std::move(system.phi));
  double correction = 0;
  for (std::size_t j = 0; j < step.size(); ++j) {
    const int i = part.unknowns[j];
    state_.q[i] -= step[j];
    const double relative_step = std::abs(static_cast<double>(step[j])) / magnitude_[i];
    if (!(relative_step <= correction)) correction = relative_step;  // NaN stays
  }
  return correction;
}

}  // namespace desmo
