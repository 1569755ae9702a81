// Rows between those solved are judged like them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "formulations/id.h"
#include "formulations/verification/error.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/dead_point.h"
#include "tests/discard.h"

namespace desmo {
namespace {

MonitoredSummary run_with_stride(const Model& m, const TimeGrid& grid, const std::string& id,
                                 Observer& observer, MonitoredRunOptions options = {}) {
  const Configuration c = parse_id(id);
  return run_monitored(*make_formulation(*c.variant, m, c.settings), grid, {}, observer, options);
}

const char* const with_strides[] = {"global_automatic_klu/stride:2",
                                    "group_symbolic_inlined/stride:8",
                                    "group_symbolic_explicit/stride:16"};

/// A crank that swings up to its dead point but for 1e-6 rad, and back.
Model swinging_near() {
  return locking_four_bar(HarmonicSum{dead_point - 1e-6 - 0.5, {{0.5, 2 * std::numbers::pi, 0}}});
}

TEST(Strides, GiveRowsNearADeadPointThatAreRightToTheBoundsStated) {
  const Model m = swinging_near();
  const TimeGrid grid{0, 0.01, 101};
  const Reference reference = make_reference(m, sampled(grid, 101));
  for (const char* id : with_strides) {
    ErrorMeasure measure(m, reference.instants, reference.scales);
    const MonitoredSummary s = run_with_stride(m, grid, id, measure);
    EXPECT_EQ(s.instants, grid.instants) << id;
    ASSERT_EQ(measure.error().instants, grid.instants) << id;
    EXPECT_GT(s.corrected, 0) << id;
    for (const Level level : levels) EXPECT_LE(measure.error()[level].max, s.bound[level]) << id;
    EXPECT_LE(measure.error().position.max, 1e-10) << id;
  }
}

TEST(Strides, AreAsRightAsTheToleranceAsksForWhereTheyAreLong) {
  const Model m = make_model(library_scene("jansen_leg"));
  const TimeGrid grid{0, 0.01, 97};
  const Reference reference = make_reference(m, sampled(grid, 97));
  for (const char* id : {"global_automatic_klu/stride:16", "group_symbolic_explicit/stride:16"}) {
    ErrorMeasure measure(m, reference.instants, reference.scales);
    const MonitoredSummary s = run_with_stride(m, grid, id, measure);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_LE(measure.error().position.max, 1e-10) << id;
    EXPECT_LE(measure.error().velocity.max, 1e-8) << id;
    EXPECT_LE(measure.error().acceleration.max, 1e-6) << id;
  }
}

TEST(Strides, KeepRowsThatAreGoodEnough) {
  const Model m = make_model(library_scene("slider_crank"));
  Discard observer;
  const MonitoredSummary s =
      run_with_stride(m, {0, 1e-3, 1001}, "group_symbolic_explicit/stride:2", observer);
  EXPECT_EQ(s.outcome(), Outcome::converged);
  EXPECT_EQ(s.corrected, 0);
}

/// A crank that is told to swing 0.1 rad beyond its dead point: no stride ends where it locks.
TEST(Strides, FindIntervalsThatCannotBeAssembledAsStepsDo) {
  const Model m = locking_four_bar(HarmonicSum{dead_point - 0.5, {{0.6, 2 * std::numbers::pi, 0}}});
  const double locked = std::asin(0.5 / 0.6) / (2 * std::numbers::pi);
  const TimeGrid grid{0, 0.01, 101};
  MonitoredRunOptions options;
  options.past_failures = true;
  for (const char* id : with_strides) {
    Discard observer;
    const MonitoredSummary s = run_with_stride(m, grid, id, observer, options);
    ASSERT_EQ(s.gaps.size(), 1u) << id;
    EXPECT_NEAR(s.gaps.front().from, locked, 2e-9) << id;
    EXPECT_NEAR(s.gaps.front().to, 0.5 - locked, 2e-9) << id;
    long before = 0;
    for (int i = 0; i < grid.instants; ++i)
      before += grid.time(i) < locked || grid.time(i) > 0.5 - locked;
    EXPECT_EQ(s.instants, before) << id;
  }
}

}  // namespace
}  // namespace desmo
