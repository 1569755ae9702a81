#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/instructions/step_counts.h"

namespace desmo::instructions {

/// What an early prototype of this suite took a step, for the truck suspension with 558
/// coordinates; nothing where there was none.
std::optional<std::int64_t> of_prototype(const StepCount& count);

/// Claims that the counts contradict, a sentence each: nothing takes more than a tenth more than
/// the prototype did; symbolic equations beat automatic ones with every solver in the truck's
/// groups; the explicit order beats the generated elimination; that beats every solver in the
/// four-bar.
std::vector<std::string> broken_claims(const std::vector<StepCount>& counts);

}  // namespace desmo::instructions
