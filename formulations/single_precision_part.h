#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "formulations/newton_solver.h"
#include "formulations/part.h"

namespace desmo {

/// The state in single precision, shared by the parts of a formulation.
struct SinglePrecisionState {
  std::vector<float> q, qd, qdd;

  explicit SinglePrecisionState(int size) : q(size), qd(size), qdd(size) {}
};

/// A part solved in single precision: what it reads of the state is rounded, and what it finds
/// are single numbers, kept in the double ones of the state.
template <class Equations, class Algebra>
class SinglePrecisionPart final : public Part {
 public:
  /// read: positions in the state of all that the equations read, unknowns among them.
  template <class... AlgebraArguments>
  SinglePrecisionPart(Equations equations, std::span<const double> weights,
                      std::span<const double> magnitudes, const PartSettings& settings,
                      std::shared_ptr<SinglePrecisionState> state, std::vector<int> read,
                      AlgebraArguments&&... arguments)
      : solver_(std::move(equations), weights, magnitudes, settings, arguments...),
        state_(std::move(state)),
        read_(std::move(read)) {}

  PartResult solve(State& s, std::span<const double>, Level level) override {
    for (const int i : read_) {
      state_->q[i] = static_cast<float>(s.q[i]);
      state_->qd[i] = static_cast<float>(s.qd[i]);
      state_->qdd[i] = static_cast<float>(s.qdd[i]);
    }
    const PartResult result =
        solver_.solve(state_->q.data(), state_->qd.data(), state_->qdd.data(), level);
    for (const int i : solver_.pattern().unknowns) {
      s.q[i] = state_->q[i];
      s.qd[i] = state_->qd[i];
      s.qdd[i] = state_->qdd[i];
    }
    return result;
  }

 private:
  NewtonSolver<Equations, Algebra> solver_;
  std::shared_ptr<SinglePrecisionState> state_;
  std::vector<int> read_;
};

}  // namespace desmo
