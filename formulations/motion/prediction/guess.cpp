#include "formulations/motion/prediction/guess.h"

#include <array>
#include <cmath>

namespace desmo {

namespace {

/// A guess, and the levels to which the last instant and the one before must have been solved.
struct GuessKind {
  std::string_view name;
  Level last;
  std::optional<Level> before{};
};

constexpr std::array kinds{
    // one for each enumerator of Guess, in order
    GuessKind{"previous", Level::position},
    GuessKind{"linear", Level::velocity},
    GuessKind{"quadratic", Level::acceleration},
    GuessKind{"hermite3", Level::velocity, Level::velocity},
    GuessKind{"hermite5", Level::acceleration, Level::acceleration},
    GuessKind{"adams8", Level::acceleration, Level::acceleration},
};

const GuessKind& kind_of(Guess guess) { return kinds[static_cast<std::size_t>(guess)]; }

}  // namespace

std::string_view guess_name(Guess guess) { return kind_of(guess).name; }

std::vector<std::string_view> guess_names() {
  std::vector<std::string_view> names;
  for (const GuessKind& kind : kinds) names.push_back(kind.name);
  return names;
}

Guess best_guess(Guess wanted, const StepHistory& history) {
  const bool apart = std::abs(history.h) < max_step_growth * std::abs(history.h_before);
  for (const Guess guess : {Guess::hermite5, Guess::hermite3, Guess::quadratic, Guess::linear}) {
    const auto& [name, last, before] = kind_of(guess);
    if (guess <= wanted && history.last >= last && (!before || (apart && history.before >= before)))
      return guess;
  }
  return Guess::previous;
}

Prediction::Prediction(Guess guess, const StepHistory& history) : guess_(guess) {
  const double h = history.h, k = history.h_before, r = h / k, s = 1 + r;
  // Hermite's basis on [0, 1] at s = 1 + r. There, 0 is the instant before the last, 1 the last
  // one, k seconds later, and s the predicted one. The basis is factored about its zeros at 1, so
  // that nothing cancels there.
  switch (guess_) {
    case Guess::previous:
    case Guess::adams8:
      return;
    case Guess::linear:
      w_v1_ = h;
      return;
    case Guess::quadratic:
      w_v1_ = h;
      w_a1_ = h * h / 2;
      return;
    case Guess::hermite3:
      w_q_ = r * r * (3 + 2 * r);
      w_v0_ = k * s * r * r;
      w_v1_ = h * s * s;
      return;
    case Guess::hermite5:
      w_q_ = -r * r * r * (10 + r * (15 + 6 * r));
      w_v0_ = -k * r * r * r * s * (4 + 3 * r);
      w_a0_ = -k * k / 2 * r * r * r * s * s;
      w_v1_ = h * s * s * s * (1 - 3 * r);
      w_a1_ = h * h / 2 * s * s * s;
  }
}

}  // namespace desmo
