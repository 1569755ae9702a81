// Rates from pivots of another position.

#include <gtest/gtest.h>

#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/error.h"
#include "formulations/verification/monitor/accuracy_monitor.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/safety/recipes.h"

namespace desmo {
namespace {

/// Without what residuals show there would be.
TEST(ReusedPivots, ShowInTheResidualsOfRates) {
  const Model m = oscillating_block();
  const TimeGrid grid{0, 1e-5, 201};
  const Reference reference = make_reference(m, sampled(grid, 201));
  ErrorMeasure measure(m, reference.instants, reference.scales);
  const auto f = make_formulation(find_variant("global_automatic_klu"), m, {});
  const MonitoredSummary s =
      run_monitored_without(static_cast<unsigned>(Monitor::pivots), *f, grid, {}, measure, {});
  EXPECT_EQ(s.outcome(), Outcome::converged);
  EXPECT_GT(measure.error().velocity.max, 10 * s.bound.velocity);
}

TEST(ReusedPivots, LeaveNoErrorAboveTheBoundsStated) {
  const Model m = oscillating_block();
  const TimeGrid grid{0, 1e-5, 201};
  const Reference reference = make_reference(m, sampled(grid, 201));
  for (const char* id : {"global_automatic_klu", "group_automatic_klu", "block_automatic_klu"}) {
    ErrorMeasure measure(m, reference.instants, reference.scales);
    const MonitoredSummary s =
        run_monitored(*make_formulation(find_variant(id), m, {}), grid, {}, measure, {});
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    ASSERT_EQ(measure.error().instants, grid.instants);
    EXPECT_LT(measure.error().velocity.max, 1e-9) << id;
    for (const Level level : all_levels)
      EXPECT_LE(measure.error()[level].max, s.bound[level]) << id;
  }
}

}  // namespace
}  // namespace desmo
