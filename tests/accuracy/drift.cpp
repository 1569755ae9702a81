// A long run in short: what its error grows by is the rounding of the angle that drives it.

#include "formulations/verification/reference/drift.h"

#include <gtest/gtest.h>

#include <numbers>

#include "formulations/variants.h"
#include "tests/accuracy/scenes.h"

namespace desmo::drift_test {
namespace {

TEST(Drift, IsTheRoundingOfTheDriver) {
  const int steps = DESMO_TEST_SECONDS < 30 ? 2'000 : 10'000;
  const Scene scene = library_scene("slider_crank");
  const Model m = make_model(scene);
  const TimeGrid grid{0, scene.grid.step, steps};
  const double turned = 2 * std::numbers::pi * grid.time(steps);  // one turn a second
  for (const char* id : {"global_automatic_klu", "group_symbolic_inlined"}) {
    const auto f = make_formulation(find_variant(id), m, {.fixed_iterations = 12});
    const Drift d = measure_drift(*f, grid, 200);
    ASSERT_TRUE(d.summary.ok()) << describe(d.summary, m);
    EXPECT_EQ(d.first.instants, 200);
    EXPECT_EQ(d.last.instants, 200);
    // The angle is off by half a unit in its last place, up to turned · 2⁻⁵³, and so is all else.
    EXPECT_GT(d.last.position.max, 2 * d.first.position.max);
    EXPECT_GT(d.last.position.max, turned * 0x1p-53 / 8);
    for (const Level level : levels) {
      EXPECT_LE(d.floor[level], 1e-25);
      EXPECT_LE(d.last[level].max, 2 * d.first[level].max + 4 * turned * 0x1p-53)
          << id << ", level " << static_cast<int>(level);
    }
  }
}

TEST(Drift, TakesNoMoreInstantsThanThereAre) {
  const Scene scene = library_scene("slider_crank");
  const Model m = make_model(scene);
  const auto f = make_formulation(find_variant("global_automatic_klu"), m);
  const Drift d = measure_drift(*f, {0, scene.grid.step, 7}, 1000);
  EXPECT_EQ(d.first.instants, 3);
  EXPECT_EQ(d.last.instants, 3);
}

}  // namespace
}  // namespace desmo::drift_test
