#include "formulations/guess.h"

namespace desmo {

std::string_view guess_name(Guess guess) {
  switch (guess) {
    case Guess::previous:
      return "previous";
    case Guess::quadratic:
      return "quadratic";
  }
  return {};
}

Level level_needed(Guess guess) {
  return guess == Guess::previous ? Level::position : Level::acceleration;
}

void extrapolate(Guess guess, std::span<const int> coordinates, double h, State& s) {
  switch (guess) {
    case Guess::previous:
      return;
    case Guess::quadratic:
      for (const int i : coordinates) s.q[i] += h * (s.qd[i] + h / 2 * s.qdd[i]);
  }
}

}  // namespace desmo
