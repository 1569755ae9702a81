#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/constraints/constraints.h"
#include "formulations/model/part_system.h"
#include "formulations/model/scales.h"

namespace desmo {

/// The base of solvers of reference solutions: an instant of a whole model in the scalar S, and
/// functions to set and read it. Derived classes evaluate and solve the equations, so that two
/// solvers that check each other share no more than this.
template <class S>
class ReferenceSolver {
  static_assert(EquationScalar<S> && TableScalar<S>);

 public:
  /// Sets the start of the next Newton iteration to the positions of another solver.
  template <class T>
  void start_at(const ReferenceSolver<T>& other) {
    for (int i = 0; i < m_.coordinates(); ++i) state_.q[i] = other.state().q[i];
  }
  /// Sets the positions of all coordinates.
  void place(const std::vector<S>& q) { std::ranges::copy(q, state_.q.begin()); }
  /// Sets the positions of the drivers, in the model's order, and nothing else.
  void drive(std::span<const S> drivers) {
    for (std::size_t k = 0; k < drivers.size(); ++k) state_.q[driven(k)] = drivers[k];
  }
  /// Sets the positions, velocities and accelerations of the drivers, in the model's order.
  void drive(std::span<const MotionSample<S>> drivers) {
    for (std::size_t k = 0; k < drivers.size(); ++k) {
      state_.q[driven(k)] = drivers[k].position;
      state_.qd[driven(k)] = drivers[k].velocity;
      state_.qdd[driven(k)] = drivers[k].acceleration;
    }
  }
  /// Sets the state to one that state() returned.
  void restore(const ScalarState<S>& state) { state_ = state; }

  /// Return the instant solved last, in coordinate order.
  std::vector<S> q() const { return coordinates(state_.q); }
  std::vector<S> qd() const { return coordinates(state_.qd); }
  std::vector<S> qdd() const { return coordinates(state_.qdd); }
  const ScalarState<S>& state() const { return state_; }

 protected:
  /// Starts at the model's initial estimate, at rest.
  explicit ReferenceSolver(const Model& m)
      : m_(m), state_(m.state_size()), magnitude_(nominal_magnitudes(m)) {
    std::ranges::copy(m.estimate, state_.q.begin());
    for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
      state_.q[m.coordinates() + i] = as<S>(m.fixed_value(i));
  }
  ~ReferenceSolver() = default;

  /// Sets the drivers to their motions at time t [s].
  void drive_to(double t) {
    std::vector<MotionSample<S>> drivers;
    for (const Driver& d : m_.drivers) drivers.push_back(sample(d.motion, S(t)));
    drive(drivers);
  }

  /// Subtracts a correction of some unknowns from the positions or from one of their rates. Returns
  /// its largest component relative to the nominal magnitude of the coordinate; NaN if one is NaN.
  double subtract(std::span<const S> step, const std::vector<int>& unknowns,
                  std::vector<S>& values) const {
    double largest = 0;
    for (std::size_t j = 0; j < step.size(); ++j) {
      const int i = unknowns[j];
      values[i] -= step[j];
      const double relative_step = std::abs(static_cast<double>(step[j])) / magnitude_[i];
      if (relative_step > largest || std::isnan(relative_step)) largest = relative_step;
    }
    return largest;
  }

  const Model& m_;
  ScalarState<S> state_;

 private:
  int driven(std::size_t k) const { return m_.entities[m_.drivers[k].coordinate].first; }
  std::vector<S> coordinates(const std::vector<S>& values) const {
    return {values.begin(), values.begin() + m_.coordinates()};
  }

  std::vector<double> magnitude_;  // nominal magnitude of each coordinate
};

}  // namespace desmo
