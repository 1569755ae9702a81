#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "formulations/accuracy/part_system.h"
#include "formulations/accuracy/scales.h"
#include "formulations/accuracy/settling.h"

namespace desmo {

/// Solves a mechanism group by group with dense matrices and pivoting, in the scalar S, by the
/// equations of the paper: Newton's method (eq. 2), velocities (eq. 3) and accelerations (eq. 4)
/// from the partial derivatives and quadratic terms that each constraint kind states.
template <class S>
class GroupwiseSolver {
 public:
  /// Starts at the mechanism's estimate. The mechanism must outlive the solver.
  explicit GroupwiseSolver(const Mechanism& m)
      : m_(m),
        parts_(make_partition(m, Partition::group)),
        magnitude_(natural_magnitudes(m)),
        state_(m.state_size()) {
    std::ranges::copy(m.estimate, state_.q.begin());
    std::ranges::copy(m.fixed_values, state_.q.begin() + m.coordinates());
  }

  /// Newton starts there next: the positions of another solver.
  template <class T>
  void start_at(const GroupwiseSolver<T>& other) {
    std::ranges::copy(other.state().q, state_.q.begin());
  }

  /// As exactly as S allows, from where it is. Throws std::runtime_error, naming the group and the
  /// instant, when Newton's method does not converge.
  void solve_positions(double t) {
    for (const Driver& d : m_.drivers) {
      const int i = m_.entities[d.coordinate].first;
      const MotionSample<S> z = sample(d.motion, S(t));
      state_.q[i] = z.position;
      state_.qd[i] = z.velocity;
      state_.qdd[i] = z.acceleration;
    }
    for (const PartDefinition& part : parts_) solve_positions(part, t);
  }

  /// Velocities and accelerations at the positions solved last.
  void solve_rates() {
    for (const PartDefinition& part : parts_) {
      const System before(m_, part, state_);
      const Eigen::PartialPivLU<typename System::Matrix> lu(before.jacobian);
      const Vector velocity = lu.solve(before.velocity);
      for (std::size_t j = 0; j < part.unknowns.size(); ++j)
        state_.qd[part.unknowns[j]] = velocity[j];
      const System after(m_, part, state_);  // Φ̇_q q̇ depends on the velocities just found
      const Vector acceleration = lu.solve(after.acceleration);
      for (std::size_t j = 0; j < part.unknowns.size(); ++j)
        state_.qdd[part.unknowns[j]] = acceleration[j];
    }
  }

  /// The instant solved last, in coordinate order.
  std::vector<S> q() const { return coordinates(state_.q); }
  std::vector<S> qd() const { return coordinates(state_.qd); }
  std::vector<S> qdd() const { return coordinates(state_.qdd); }
  const WideState<S>& state() const { return state_; }

 private:
  using System = PartSystem<S>;
  using Vector = System::Vector;

  void solve_positions(const PartDefinition& part, double t) {
    Settling<S> settled;
    for (int iteration = 0; iteration < 50; ++iteration) {
      const System system(m_, part, state_);
      const Vector step =
          Eigen::PartialPivLU<typename System::Matrix>(system.jacobian).solve(system.phi);
      double correction = 0;
      for (std::size_t j = 0; j < part.unknowns.size(); ++j) {
        const int i = part.unknowns[j];
        state_.q[i] -= step[j];
        const double relative_step = std::abs(static_cast<double>(step[j])) / magnitude_[i];
        if (!(relative_step <= correction)) correction = relative_step;  // NaN stays
      }
      if (settled(correction)) return;
    }
    throw std::runtime_error(m_.name + ", group '" + m_.groups[part.groups.front()].name +
                             "': no reference solution at t = " + std::to_string(t) + " s");
  }

  std::vector<S> coordinates(const std::vector<S>& values) const {
    return {values.begin(), values.begin() + m_.coordinates()};
  }

  const Mechanism& m_;
  std::vector<PartDefinition> parts_;
  std::vector<double> magnitude_;  // of each coordinate
  WideState<S> state_;
};

}  // namespace desmo
