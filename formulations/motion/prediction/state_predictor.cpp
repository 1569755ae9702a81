#include "formulations/motion/prediction/state_predictor.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace desmo {

StatePredictor::StatePredictor(Guess wanted, std::span<const DefinedPart> parts) {
  std::array<std::vector<int>, 3> unknowns;
  for (const DefinedPart& part : parts) {
    if (part.definition.constant) continue;
    const PartInputs inputs = part.solver->inputs(
        {.predicted = part.definition.unknowns, .unwrapped = {}, .others = {}, .drivers = {}});
    std::ranges::copy(inputs.predicted,
                      std::back_inserter(unknowns[static_cast<std::size_t>(part.level)]));
    std::ranges::copy(inputs.unwrapped, std::back_inserter(unwrapped_));
  }
  for (std::size_t level = 0; level < unknowns.size(); ++level) {
    std::ranges::sort(unknowns[level]);
    // adams8 needs the accelerations of earlier instants.
    const Guess guess = static_cast<Level>(level) == Level::acceleration
                            ? wanted
                            : std::min(wanted, Guess::hermite5);
    of_level_[level] = Predictor(guess, ranges_of(unknowns[level]));
  }
}

}  // namespace desmo
