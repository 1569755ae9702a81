#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "formulations/base/settings.h"
#include "formulations/base/state.h"
#include "formulations/model/partition.h"
#include "formulations/motion/prediction/predictor.h"

namespace desmo {

/// Predicts the state from which the parts of a formulation start in a step.
class StatePredictor {
 public:
  StatePredictor() = default;
  /// guess: the one wanted. parts: all parts; inputs of the moving ones are predicted.
  StatePredictor(Guess guess, std::span<const DefinedPart> parts);

  /// Writes predicted positions into state.q. last, before: the last instant and the one before it,
  /// of which only what the prediction needs is read. `state` may be `before`.
  void operator()(const StepHistory& history, const State& last, const State& before,
                  State& state) {
    for (std::size_t level = 0; level < of_level_.size(); ++level)
      if (Predictor& predictor = of_level_[level]; !predictor.empty())
        predictor(history.up_to(static_cast<Level>(level)), last, before, state.q.data());
    for (const int i : unwrapped_) state.q[i] = last.q[i];
  }

 private:
  std::array<Predictor, 3> of_level_;  // one for the unknowns solved up to each level
  std::vector<int> unwrapped_;         // coordinates that start at their last value
};

}  // namespace desmo
