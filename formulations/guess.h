#pragma once

#include <span>
#include <string_view>

#include "formulations/part.h"

namespace desmo {

/// How a guess is written in ids: "previous", "quadratic".
std::string_view guess_name(Guess guess);

/// The level to which the last instant must have been solved for this guess; without it a step
/// starts from the previous positions.
Level level_needed(Guess guess);

/// Moves q of these coordinates from the instant that `state` holds to where the guess expects them
/// h seconds later.
void extrapolate(Guess guess, std::span<const int> coordinates, double h, State& state);

}  // namespace desmo
