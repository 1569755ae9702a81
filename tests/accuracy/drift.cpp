// A long run in short: what its error grows by is the rounding of the angle that drives it.

#include <gtest/gtest.h>

#include <numbers>
#include <span>
#include <vector>

#include "formulations/variants.h"
#include "formulations/verification/error.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"

namespace desmo::drift_test {
namespace {

TEST(Drift, IsTheRoundingOfTheDriver) {
  const int steps = DESMO_TEST_SECONDS < 30 ? 2'000 : 10'000, window = 200;
  const Scene scene = library_scene("slider_crank");
  const Model m = make_model(scene);
  const TimeGrid grid{0, scene.grid.step, steps};
  std::vector<double> times;
  for (int i = 0; i < steps; i += i == window - 1 ? steps - 2 * window + 1 : 1)
    times.push_back(grid.time(i));
  const Reference reference = make_reference(m, times);
  for (const Level level : all_levels) EXPECT_LE(reference.floor[level], 1e-25);
  const double turned = 2 * std::numbers::pi * grid.time(steps);  // one turn a second
  for (const char* id : {"global_automatic_klu", "group_symbolic_inlined"}) {
    const auto f = make_formulation(find_variant(id), m, {.fixed_iterations = 12});
    const auto error_in = [&](std::span<const ReferenceInstant> instants) {
      ErrorMeasure measure(m, instants, reference.scales);
      const Summary summary = f->run(grid, {}, measure);
      EXPECT_TRUE(summary.ok()) << describe(summary, m);
      return measure.error();
    };
    const std::span instants(reference.instants);
    const SolutionError first = error_in(instants.first(window)),
                        last = error_in(instants.subspan(window));
    EXPECT_EQ(first.instants, window);
    EXPECT_EQ(last.instants, window);
    // The angle is off by half a unit in its last place, up to turned · 2⁻⁵³, and so is all else.
    EXPECT_GT(last.position.max, 2 * first.position.max);
    EXPECT_GT(last.position.max, turned * 0x1p-53 / 8);
    for (const Level level : all_levels)
      EXPECT_LE(last[level].max, 2 * first[level].max + 4 * turned * 0x1p-53)
          << id << ", level " << static_cast<int>(level);
  }
}

}  // namespace
}  // namespace desmo::drift_test
