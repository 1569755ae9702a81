#include <numbers>
#include <stdexcept>
#include <string>

#include "cases/generators/cases.h"
#include "cases/generators/dyad_chain.h"

namespace desmo {

Scene four_bar(int dyads) {
  if (dyads < 1 || dyads > 10'000'000)
    throw std::invalid_argument("four_bar: from 1 to 10000000 dyads, not " + std::to_string(dyads));
  constexpr double link_length = 6, pivot_spacing = 6;
  DyadChain chain{.crank = 2, .start = std::numbers::pi / 3, .dyads = {}};
  chain.dyads.reserve(dyads);
  for (int k = 1; k <= dyads; ++k)
    chain.dyads.push_back(
        {{pivot_spacing * k, 0, 0}, link_length, link_length, {pivot_spacing * k - 3, 5, 0}, 2});

  MechanismBuilder builder("four_bar", 2);
  builder.set_length_unit("1");
  add(builder, chain);
  return {"four_bar", builder.release(), {Polynomial{{chain.start, 1}}}, time_grid(30, 0.01)};
}

}  // namespace desmo
