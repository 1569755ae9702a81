#pragma once

#include <cmath>
#include <numbers>

#include "cases/generators/cases.h"
#include "cases/generators/dyad_chain.h"

namespace desmo {

/// Returns the scalable four-bar, turned by 1.2 rad about the crank's pivot: no link is along an
/// axis, so that boxes along the axes do not fit the errors.
inline Scene turned_chain(int dyads) {
  constexpr double turn = 1.2, link_length = 6, spacing = 6;
  const auto turned = [](double x, double y) -> Mechanism::Vec {
    return {std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, 0};
  };
  DyadChain chain{.crank = 2, .start = std::numbers::pi / 3 + turn, .dyads = {}};
  for (int k = 1; k <= dyads; ++k)
    chain.dyads.push_back(
        {turned(spacing * k, 0), link_length, link_length, turned(spacing * k - 3, 5), 2 + turn});
  MechanismBuilder builder("turned_four_bar", 2);
  builder.set_length_unit("1");
  add(builder, chain);
  return {"turned_four_bar",
          builder.release(),
          {Polynomial{{chain.start, 1}}},
          time_grid(30, 0.01),
          {},
          {}};
}

}  // namespace desmo
