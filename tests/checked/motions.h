// Motions on which steps, strides or rounding easily lead a formulation astray.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "cases/extremes/rows.h"
#include "tests/accuracy/scenes.h"
#include "tests/checked/rows.h"

namespace desmo {

/// Crank of 1 about (0, 0), rod of 3, slider on y = 0.1, driven up to its dead point at x² = 16 −
/// 0.1² but for `distance`, and back, once a second.
inline Model driven_slider(double distance) {
  Scene scene = scene_file("driven_slider");
  const double farthest = std::sqrt(16 - 0.01) - distance;
  scene.motions[0] =
      HarmonicSum{(farthest + 3) / 2, {{(farthest - 3) / 2, 2 * std::numbers::pi, 0}}};
  return make_model(scene);
}

/// Links of a millimetre on a crank [m], at a tenth of a millimetre per second.
inline Scene small_dyad(double crank) {
  constexpr double small = 1e-3;
  return extremes::case_of(
             "small dyad",
             extremes::one_dyad(crank, small / crank, crank + small / 2, small, small),
             small / crank / 10, {0, 0.1, 11})
      .scene;
}

/// A four-bar of 60 mm on an arm that turns.
inline Scene four_bar_on_arm(std::string_view case_name) {
  const std::vector<ExtremeCase> cases = extremes::scales(Extent::brief);
  return std::ranges::find(cases, case_name, &ExtremeCase::name)->scene;
}

/// A parallelogram with cranks of 1 whose base is 2. The rocker is parallel to the crank.
inline Scene parallelogram(const Motion& crank, const TimeGrid& grid) {
  DyadChain chain{.crank = 1, .start = sample(crank, grid.start).position, .dyads = {}};
  const Mechanism::Vec pin = crank_pin(chain);
  chain.dyads = {closed_dyad(pin, {2, 0, 0}, 2, 1, -1)};
  chain.dyads[0].joint = {pin[0] + 2, pin[1], 0};
  chain.dyads[0].angle = chain.start;
  return extremes::case_of("parallelogram", {chain}, {crank}, grid).scene;
}

}  // namespace desmo
