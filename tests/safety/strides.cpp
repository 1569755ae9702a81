// Rows between those solved are judged like them, and a stride that is too long is halved.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "formulations/id.h"
#include "formulations/stepping/strided_steps.h"
#include "formulations/verification/error.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/dead_point.h"
#include "tests/discard.h"
#include "tests/safety/recipes.h"

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
    EXPECT_GT(s.shortest_stride, 0) << id;
    for (const Level level : all_levels)
      EXPECT_LE(measure.error()[level].max, s.bound[level]) << id;
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
  EXPECT_EQ(s.shortest_stride, 0);
}

struct Judged {
  MonitoredSummary summary;
  PerLevel<double> error;
};

/// Solves a motion and compares all of it with the reference.
Judged judge(const Model& m, const TimeGrid& grid, const std::string& id) {
  const Reference reference = make_reference(m, sampled(grid, grid.instants));
  ErrorMeasure measure(m, reference.instants, reference.scales);
  const MonitoredSummary s = run_with_stride(m, grid, id, measure);
  const auto e = measure.error();
  EXPECT_EQ(e.instants, grid.instants) << id;
  return {s, {e.position.max, e.velocity.max, e.acceleration.max}};
}

TEST(Strides, AreHalvedNextToADeadPointOfASlider) {
  for (const double distance : {1e-2, 1e-4, 1e-6}) {
    const Model m = make_model(driven_slider(distance));
    for (const char* id : {"global_automatic_klu/stride:2", "block_symbolic_inlined/stride:16",
                           "group_automatic_lapack/stride:7"}) {
      const auto [s, error] = judge(m, {0, 0.01, 101}, id);
      EXPECT_EQ(s.outcome(), Outcome::converged) << id << ", " << distance;
      EXPECT_EQ(s.shortest_stride, 1) << id << ", " << distance;
      for (const Level level : all_levels) EXPECT_LE(error[level], s.bound[level]) << id;
      EXPECT_LE(error.position, 1e-10) << id << ", " << distance;
    }
  }
}

TEST(Strides, AreHalvedWhereNoneIsShortEnough) {
  const Model m = make_model(library_scene("andrews"));
  const double radian = 0.5 / std::numbers::pi;  // s
  for (const char* id : {"global_automatic_klu/stride:16", "group_symbolic_explicit/stride:16"}) {
    const auto [s, error] = judge(m, {0, radian, 65}, id);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_EQ(s.shortest_stride, 1) << id;
    EXPECT_LE(error.position, 1e-10) << id;
  }
}

/// A crank that creeps, but for a kick of 2 ms at 1 s.
TEST(Strides, AreLongAgainAfterwards) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion =
      make_spline({0, 0.999, 1.0, 1.001, 2}, {0, 0.01, 0.02, 0.03, 0.04}, SplineEnds::natural);
  std::vector<int> solved;
  MonitoredRunOptions options;
  options.monitored = [&](const MonitoredInstant& i) {
    if (!i.instant.interpolated) solved.push_back(i.instant.index);
  };
  Discard observer;
  const MonitoredSummary s =
      run_with_stride(m, {0, 1e-4, 20001}, "group_symbolic_explicit/stride:16", observer, options);
  EXPECT_EQ(s.outcome(), Outcome::converged);
  EXPECT_LT(s.shortest_stride, 16);
  const auto between = [&](int first, int last) {
    return std::ranges::count_if(solved, [&](int i) { return first <= i && i < last; });
  };
  EXPECT_LE(between(0, 9600), 9600 / 14);
  EXPECT_GE(between(9900, 10100), 20);  // 13 would be 16 apart
  EXPECT_LE(between(16000, 20000), 4000 / 14);
}

TEST(StrideControl, HalvesAtOnceAndDoublesWithPatience) {
  StrideControl stride(7);
  stride.halve();
  EXPECT_EQ(stride.now(), 3);
  const auto keep = [&](int intervals) {
    for (int i = 0; i < intervals; ++i) stride.keep();
    return stride.now();
  };
  EXPECT_EQ(keep(7), 3);
  EXPECT_EQ(keep(1), 6);
  stride.halve();  // that was too early
  EXPECT_EQ(stride.now(), 3);
  EXPECT_EQ(keep(15), 3);
  EXPECT_EQ(keep(1), 6);
  EXPECT_EQ(keep(16), 7);
  EXPECT_EQ(keep(1000), 7);
  for (int i = 0; i < 5; ++i) stride.halve();
  EXPECT_EQ(stride.now(), 1);
  EXPECT_EQ(keep(7), 1);  // a long one was good for long
  EXPECT_EQ(keep(1), 2);
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
