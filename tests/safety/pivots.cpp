// Rates from pivots of another position.

#include <gtest/gtest.h>

#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/error.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"

namespace desmo {
namespace {

/// A crank of 1 whose pin slides in a block that turns 2.5 away. Where the crank points at the
/// block, the direction of the slide has one component that is all but zero.
Model oscillating_block() {
  return make_model(parse_scene(R"({
    "format": "desmo-scene", "version": 1,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "block", "dimension": 2,
      "points": {"O": [0, 0], "A": [0, 1], "D": [2.5, 0]},
      "vectors": {"u": [-2.5, 1]},
      "ground": {"points": ["O", "D"]},
      "bodies": {"crank": {"points": ["O", "A"]}, "rod": {"points": ["A"], "vectors": ["u"]},
                 "block": {"points": ["D"], "vectors": ["u"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
        {"type": "revolute", "bodies": ["crank", "rod"], "points": ["A"]},
        {"type": "prismatic", "bodies": ["block", "rod"], "vectors": ["u"],
         "points": ["D", "A"]},
        {"type": "revolute", "bodies": ["ground", "block"], "points": ["D"]}],
      "coordinates": {"theta": {"angle": ["O", "A"]}, "psi": {"angle": "u"},
                      "s": {"distance": ["D", "A"], "along": "u"}},
      "drivers": ["theta"]},
    "motion": {"theta": {"type": "polynomial", "coefficients": [-0.001, 1]}},
    "time": {"end": 0.002, "step": 1e-5}})",
                                "block.scene.json", ""));
}

/// Without what residuals show there would be.
TEST(ReusedPivots, ShowInTheResidualsOfRates) {
  const Model m = oscillating_block();
  const TimeGrid grid{0, 1e-5, 201};
  const Reference reference = make_reference(m, sampled(grid, 201));
  MonitoredRunOptions options;
  options.without = static_cast<unsigned>(Monitor::residual);
  ErrorMeasure measure(m, reference.instants, reference.scales);
  const MonitoredSummary s = run_monitored(
      *make_formulation(find_variant("global_automatic_klu"), m, {}), grid, {}, measure, options);
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
    for (const Level level : levels) EXPECT_LE(measure.error()[level].max, s.bound[level]) << id;
  }
}

}  // namespace
}  // namespace desmo
