#include "formulations/parts/single_precision_part.h"

#include <utility>

#include "formulations/algebra/backend.h"
#include "formulations/equations/automatic.h"
#include "formulations/parts/newton_solver.h"
#include "formulations/parts/profiled.h"

namespace desmo {

namespace {

class SinglePrecisionPart final : public Part {
 public:
  SinglePrecisionPart(std::unique_ptr<const Equations<float>> equations, const PartContext& c,
                      std::unique_ptr<LinearSolver<float>> linear_solver)
      : solver_(std::move(equations), c.weights, c.magnitudes, c.settings,
                std::move(linear_solver)),
        state_(c.single),
        read_(states_read(c.model, c.definition)) {}

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
  NewtonSolver<float> solver_;
  std::shared_ptr<SinglePrecisionState> state_;
  std::vector<int> read_;  // positions in the state of all that the equations read
};

}  // namespace

std::unique_ptr<Part> make_single_precision_part(const PartContext& c, const Backend& backend) {
  std::unique_ptr<const Equations<float>> equations =
      std::make_unique<BasicAutomaticEquations<float>>(c.model, c.definition);
  std::unique_ptr<LinearSolver<float>> solver = backend.make_single_solver(equations->pattern());
  if (c.profile) {
    equations = std::make_unique<ProfiledEquations<float>>(std::move(equations), *c.profile);
    solver = std::make_unique<ProfiledSolver<float>>(std::move(solver), *c.profile);
  }
  return std::make_unique<SinglePrecisionPart>(std::move(equations), c, std::move(solver));
}

}  // namespace desmo
