#include "cases/numbers/turn.h"

#include <utility>

#include "cases/numbers/derived.h"

namespace desmo {

namespace {

struct Direction {
  Derived cosine, sine;
};

/// Returns the direction at half the angle of `a`, which is between 0 and π/2.
Direction half(const Direction& a) {
  const Derived cosine = sqrt((Derived(1) + a.cosine) / Derived(2));
  return {cosine, a.sine / (Derived(2) * cosine)};
}

Direction operator*(const Direction& a, const Direction& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

}  // namespace

const std::array<Turn<double>, 128>& table_of_turns() {
  static const std::array<Turn<double>, 128> table = [] {
    Direction step{0, 1};  // direction at π/2, then at its halves
    for (int halvings = 0; halvings < 5; ++halvings) step = half(step);
    std::array<Turn<double>, 128> turns;
    Direction at{1, 0};
    for (int k = 0; k < 32; ++k, at = at * step) {
      const auto [cosine, of_cosine] = std::pair(at.cosine.value, at.cosine.correction);
      const auto [sine, of_sine] = std::pair(at.sine.value, at.sine.correction);
      turns[k] = {sine, of_sine, cosine, of_cosine, 0};
      turns[k + 32] = {cosine, of_cosine, -sine, -of_sine, 0};
      turns[k + 64] = {-sine, -of_sine, -cosine, -of_cosine, 0};
      turns[k + 96] = {-cosine, -of_cosine, sine, of_sine, 0};
    }
    return turns;
  }();
  return table;
}

}  // namespace desmo
