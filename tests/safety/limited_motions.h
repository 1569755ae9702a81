// Motions that cannot be solved to the promise, each for another cause.
#pragma once

#include <string_view>
#include <vector>

#include "formulations/verification/assessment/assessment.h"
#include "tests/accuracy/scenes.h"
#include "tests/dead_point.h"
#include "tests/safety/recipes.h"

namespace desmo {

/// A motion, and what keeps it from being as accurate as its tolerance asks for.
struct LimitedMotion {
  std::string_view name;
  Model model;
  TimeGrid grid;
  Limit limit;
};

/// A slider-crank of half a metre, 10,000 km away.
inline Model far_slider_crank() {
  Scene scene = library_scene("slider_crank");
  for (Mechanism::Point& p : scene.mechanism.points) p.position[0] += 1e7;
  return make_model(scene);
}

inline std::vector<LimitedMotion> limited_motions() {
  const Scene small = small_dyad(1e4);
  return {{"near a dead point",
           locking_four_bar(Polynomial{{dead_point - 1e-11, 1}}),
           {0, 1, 1},
           Limit::singular_position},
          {"at late times", four_bar_model(1), {0x1p26, 0.125, 9}, Limit::drivers},
          {"far from the origin", far_slider_crank(), {0, 0.0025, 41}, Limit::origin},
          {"a millimetre on ten kilometres", make_model(small), small.grid, Limit::sizes}};
}

}  // namespace desmo
