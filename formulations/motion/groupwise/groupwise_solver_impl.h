// Definitions, instantiated once for each scalar: double_solution.cpp, and
// groupwise_quadruple.cpp of verification/reference.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "formulations/constraints/kind_functions.h"
#include "formulations/model/part_system.h"
#include "formulations/motion/groupwise/dense_lu.h"
#include "formulations/motion/groupwise/groupwise_solver.h"
#include "formulations/motion/groupwise/stopping_rule.h"

namespace desmo {

template <class S>
GroupwiseSolver<S>::GroupwiseSolver(const Model& m)
    : ReferenceSolver<S>(m), parts_(make_partition(m, Partition::group)) {}

template <class S>
void GroupwiseSolver<S>::solve_positions(double t) {
  this->drive_to(t);
  for (std::size_t part = 0; part < parts_.size(); ++part) solve_positions(part, t);
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
    if (correction > largest || std::isnan(correction)) largest = correction;
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
  StoppingRule<S> stops_after;
  for (int iteration = 0; iteration < stops_after.max_corrections; ++iteration)
    if (stops_after(correct(part))) return;
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
  return this->subtract(step, part.unknowns, state_.q);
}

}  // namespace desmo
