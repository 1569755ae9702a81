// Whole runs, watched: what ordinary motions, dead points and change points end as.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/variants.h"
#include "formulations/verification/error.h"
#include "formulations/verification/monitor/accuracy_monitor.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/dead_point.h"
#include "tests/discard.h"
#include "tests/safety/recipes.h"

namespace desmo::run_test {
namespace {

MonitoredSummary run(const Model& m, const TimeGrid& grid, const char* id, Observer& observer,
                     MonitoredRunOptions options = {}, const Settings& settings = {}) {
  return run_monitored(*make_formulation(find_variant(id), m, settings), grid, {}, observer,
                       options);
}

TEST(MonitoredRun, FindsOrdinaryMotionsConverged) {
  for (const char* id :
       {"global_automatic_klu", "group_symbolic_inlined", "group_symbolic_explicit"})
    for (const auto& [m, grid] : every_motion()) {
      Discard observer;
      const MonitoredSummary s = run(m, grid, id, observer);
      EXPECT_EQ(s.outcome(), Outcome::converged) << m.name << ", " << id << ": " << describe(s, m);
      EXPECT_EQ(describe(s, m).rfind("converged: ", 0), 0) << describe(s, m);
      EXPECT_EQ(s.instants, grid.instants);
      EXPECT_LT(s.assessed, 8 + s.instants / 4) << m.name << ", " << id;
    }
}

TEST(MonitoredRun, BoundsTheErrorsOfLibraryMotions) {
  for (const LibraryMechanism& l : library()) {
    const Scene scene = library_scene(l.name);
    const Model m = make_model(scene);
    const Reference reference = make_reference(m, sampled(scene.grid, 33));
    for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
      for (const bool assesses_all : {true, false}) {
        ErrorMeasure measure(m, reference.instants, reference.scales);
        MonitoredRunOptions options;
        options.assesses_all = assesses_all;
        const MonitoredSummary s = run(m, scene.grid, id, measure, options);
        ASSERT_EQ(measure.error().instants, 33);
        for (const Level level : all_levels) {
          EXPECT_LE(measure.error()[level].max, s.bound[level]) << l.name << ", " << id;
        }
      }
    }
  }
}

/// A crank that swings up to its dead point but for a little, and back.
Model swinging(double distance) {
  constexpr double amplitude = 0.5;
  return locking_four_bar(
      HarmonicSum{dead_point - distance - amplitude, {{amplitude, 2 * std::numbers::pi, 0}}});
}

TEST(MonitoredRun, IsDegradedNearADeadPointAndRightToItsBounds) {
  for (const double distance : {1e-11, 1e-12})
    for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
      const Model m = swinging(distance);
      const TimeGrid grid{0, 1e-3, 501};
      const Reference reference = make_reference(m, std::vector{0.1, 0.249, 0.25});
      ErrorMeasure measure(m, reference.instants, reference.scales);
      const MonitoredSummary s = run(m, grid, id, measure);
      EXPECT_EQ(s.outcome(), Outcome::degraded) << distance << ", " << id;
      ASSERT_TRUE(s.first_degraded);
      EXPECT_NEAR(s.first_degraded->time, 0.25, 0.002);
      EXPECT_LT(s.degraded, 8);
      EXPECT_GT(s.condition, 0.2 / std::sqrt(distance));
      EXPECT_EQ(describe(s, m).rfind(
                    "degraded: instants " + std::to_string(s.degraded) + ", the first", 0),
                0)
          << describe(s, m);
      for (const Level level : all_levels)
        EXPECT_LE(measure.error()[level].max, s.bound[level]) << distance << ", " << id;
    }
}

TEST(MonitoredRun, FailsAtASingularPosition) {
  const Model m = locking_four_bar(Polynomial{{dead_point - 0.25, 1}});
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
    Discard observer;
    const MonitoredSummary s = run(m, {0, 0.25, 2}, id, observer);
    EXPECT_EQ(s.outcome(), Outcome::failed) << id;
    EXPECT_EQ(s.instants, 1) << id;
    EXPECT_NEAR(s.time, 0.25, 1e-12) << id;
    ASSERT_GE(s.group, 0) << id;
    EXPECT_EQ(m.groups[s.group].name, "dyad1/SG-I") << id;
  }
}

TEST(MonitoredRun, SaysOfAFailureWhatWasFlaggedBefore) {
  const Model m = locking_four_bar(Polynomial{{dead_point - 0.25 - 1e-10, 1}});
  Discard observer;
  const MonitoredSummary s = run(m, {0, 0.25, 3}, "group_symbolic_inlined", observer);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  EXPECT_EQ(s.instants, 2);
  EXPECT_TRUE(describe(s, m).ends_with("; degraded before: instants 1, the first at t = 0.25 s"))
      << describe(s, m);
}

TEST(MonitoredRun, HasNothingToDoubtWhereAllIsFixed) {
  Model m;
  m.add_fixed(EntityKind::point, "A", std::vector<double>{1, 2});
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
    Discard observer;
    const MonitoredSummary s = run(m, {0, 1, 3}, id, observer);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_EQ(s.instants, 3) << id;
  }
}

TEST(MonitoredRun, StrictEndsAtTheFirstDegradedInstant) {
  const Model m = swinging(1e-11);
  Discard observer;
  const MonitoredSummary s = run(m, {0, 1e-3, 501}, "group_symbolic_inlined", observer, {{}, true});
  EXPECT_TRUE(s.refused);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  ASSERT_TRUE(s.first_degraded);
  EXPECT_EQ(s.instants, s.first_degraded->index);
  EXPECT_EQ(describe(s, m).rfind("refused: ", 0), 0) << describe(s, m);
}

/// A crank that is told to swing 0.1 rad beyond its dead point, of 0.6 rad.
Model overswinging() {
  return locking_four_bar(HarmonicSum{dead_point - 0.5, {{0.6, 2 * std::numbers::pi, 0}}});
}
const double locked = std::asin(0.5 / 0.6) / (2 * std::numbers::pi);  // until 0.5 s less that

class Times final : public Observer {
 public:
  Flow observe(const Instant& instant) noexcept override {
    EXPECT_TRUE(indices.empty() || instant.index > indices.back());
    indices.push_back(instant.index);
    return Flow::go_on;
  }
  std::vector<int> indices;
};

/// Ends are as accurate as time is, where its rounding is more than 1e-9 s.
TEST(MonitoredRun, FindsTheEndsOfGapsAtLateTimes) {
  const double start = std::numbers::pi / 3;
  MonitoredRunOptions options;
  options.past_failures = true;
  for (const double late : {1e5, 1e6, 1e9}) {
    Model m = locking_four_bar();
    m.drivers[0].motion = Polynomial{{start - late, 1}};
    Discard observer;
    const MonitoredSummary s = run(m, {late, 0.5, 13}, "group_symbolic_inlined", observer, options);
    ASSERT_EQ(s.gaps.size(), 1u) << late;
    const double rounding = 2e-9 + 4 * late * 0x1p-53;
    EXPECT_NEAR(s.gaps[0].from - late, dead_point - start, rounding) << late;
    EXPECT_NEAR(s.gaps[0].to - late, 2 * std::numbers::pi - dead_point - start, rounding) << late;
  }
}

TEST(MonitoredRun, GoesOnPastAnIntervalThatCannotBeAssembled) {
  const Model m = overswinging();
  const TimeGrid grid{0, 1e-2, 101};
  MonitoredRunOptions options;
  options.past_failures = true;
  for (const char* id :
       {"global_automatic_klu", "group_symbolic_inlined", "group_symbolic_explicit"}) {
    Times times;
    const MonitoredSummary s = run(m, grid, id, times, options);
    EXPECT_EQ(s.outcome(), Outcome::degraded) << id;
    ASSERT_EQ(s.gaps.size(), 1u) << id;
    const Gap& gap = s.gaps.front();
    EXPECT_TRUE(gap.ends);
    EXPECT_NEAR(gap.from, locked, 2e-9) << id;
    EXPECT_NEAR(gap.to, 0.5 - locked, 2e-9) << id;
    EXPECT_EQ(m.groups[gap.failure.group].name, "dyad1/SG-I");
    for (int i = 0; i < grid.instants; ++i)
      EXPECT_EQ(std::ranges::count(times.indices, i),
                grid.time(i) < locked || grid.time(i) > 0.5 - locked);
    EXPECT_EQ(s.instants, std::ssize(times.indices));
  }
}

TEST(MonitoredRun, EndsAtAnIntervalThatCannotBeAssembledAndSaysByHowMuch) {
  const Model m = overswinging();
  const TimeGrid grid{0, 1e-2, 101};
  Times times;
  const MonitoredSummary s = run(m, grid, "group_symbolic_inlined", times);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  EXPECT_EQ(s.time, 0.16);
  ASSERT_TRUE(s.assembly_error);
  EXPECT_TRUE(s.assembly_error->is_length);
  EXPECT_TRUE(m.constraints[s.assembly_error->constraint].name.starts_with("dyad1/"));
  // Coupler and rocker lack what is between the pin of the crank and 9 from the pivot.
  const double theta = sample(m.drivers[0].motion, s.time).position;
  const double lacking = std::hypot(8 - 2 * std::cos(theta), 2 * std::sin(theta)) - 9;
  EXPECT_GT(s.assembly_error->amount, lacking / 5);
  EXPECT_LT(s.assembly_error->amount, lacking);
}

TEST(MonitoredRun, SaysThatAChangePointWasPassed) {
  const Model m = parallelogram();
  Discard observer;
  const TimeGrid grid{0, 0.01, 400};  // θ = π/3 + t passes π at 2.09 s
  const MonitoredSummary s =
      run(m, grid, "group_symbolic_inlined", observer, {}, {.guess = Guess::quadratic});
  EXPECT_EQ(s.outcome(), Outcome::degraded);
  ASSERT_TRUE(s.crossing);
  EXPECT_LE(s.crossing->after, 2 * std::numbers::pi / 3);
  EXPECT_GE(s.crossing->before, 2 * std::numbers::pi / 3);
  EXPECT_EQ(m.groups[s.crossing->group].name, "dyad1/SG-I");
}

/// Newton's method takes the turn that the links cannot. The step is retried in shorter ones,
/// behind which the coupler stays parallel to the ground.
TEST(MonitoredRun, RepairsAJumpAtAChangePoint) {
  const Model m = parallelogram();
  struct Coupler final : Observer {
    explicit Coupler(const Model& m)
        : b(m.entities[m.find("crank/B")].first), c(m.entities[m.find("dyad1/C")].first) {}
    Flow observe(const Instant& i) noexcept override {
      turned = std::max(turned, std::abs(i.q[c + 1] - i.q[b + 1]));
      return Flow::go_on;
    }
    int b, c;
    double turned = 0;
  } coupler(m);
  const MonitoredSummary s = run(m, {0, 0.01, 300}, "group_symbolic_inlined", coupler);
  EXPECT_EQ(s.outcome(), Outcome::degraded);
  EXPECT_LE(coupler.turned, 1e-8);
  ASSERT_TRUE(s.crossing);
  EXPECT_EQ(s.crossing->kind, SingularityCrossing::Kind::passed);
  EXPECT_GE(s.crossing->before, 2.09);
  EXPECT_EQ(m.groups[s.crossing->group].name, "dyad1/SG-I");
}

/// Steps of a radian are retried in shorter ones, and found to lead where they ended.
TEST(MonitoredRun, DoesNotTakeALongStepForAJump) {
  for (const double step : {0.3, 1.0}) {
    Discard observer;
    const MonitoredSummary s =
        run(four_bar_model(1), {0, step, 21}, "group_symbolic_explicit", observer);
    EXPECT_EQ(s.outcome(), Outcome::converged) << step;
  }
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
    Discard observer;
    const MonitoredSummary s = run(make_model(library_scene("rssr")), {0, 0.125, 25}, id, observer);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
  }
}

/// An angle that may end steps of a sixth of a turn anywhere modulo whole turns.
TEST(MonitoredRun, RepairsAnAngleThatJumpsByWholeTurns) {
  const Model m = make_model(library_scene("whitworth"));
  const TimeGrid grid{0, 1. / 6, 19};
  const Reference reference = make_reference(m, sampled(grid, 19));
  ErrorMeasure measure(m, reference.instants, reference.scales);
  const MonitoredSummary s = run(m, grid, "group_automatic_klu", measure);
  EXPECT_EQ(s.outcome(), Outcome::converged);
  EXPECT_EQ(measure.error().instants, 19);
  EXPECT_LE(measure.error().position.max, 1e-10);
}

/// What a run ends as without a monitor.
MonitoredSummary without(Monitor monitor, const Model& m, const TimeGrid& grid, Observer& observer,
                         const Settings& settings = {}, Level level = Level::acceleration) {
  const auto f = make_formulation(find_variant("group_symbolic_inlined"), m, settings);
  return run_monitored_without(static_cast<unsigned>(monitor), *f, grid, {level}, observer, {});
}

/// A crank that turns at a constant rate until it has all but come to its dead point.
const Model arriving = locking_four_bar(Polynomial{{dead_point - 0.5 - 1e-12, 1}});

TEST(Monitors, OfGainTellsADeadPoint) {
  const TimeGrid grid{0, 0.01, 51};
  Discard observer;
  const auto outcome = [&](Monitor monitor) {
    return without(monitor, arriving, grid, observer, {.tolerance = 1e-14}, Level::position)
        .outcome();
  };
  const auto all = static_cast<unsigned>(Monitor::sensitivity) |
                   static_cast<unsigned>(Monitor::condition) |
                   static_cast<unsigned>(Monitor::continuity);
  EXPECT_EQ(outcome(Monitor{all}), Outcome::converged);
  EXPECT_EQ(outcome(Monitor::continuity), Outcome::degraded);
}

TEST(Monitors, OfBoundsTellADeadPoint) {
  const TimeGrid grid{0.5, 0.01, 1};
  Discard observer;
  EXPECT_EQ(without(Monitor::bounds, arriving, grid, observer).outcome(), Outcome::converged);
  EXPECT_EQ(without(Monitor{}, arriving, grid, observer).outcome(), Outcome::degraded);
}

TEST(Monitors, OfOrientationTellsAChangePoint) {
  const Model m = parallelogram();
  const TimeGrid grid{0, 0.01, 400};
  const Settings straight_on{.guess = Guess::quadratic};
  Discard observer;
  EXPECT_FALSE(without(Monitor::orientation, m, grid, observer, straight_on).crossing);
  const MonitoredSummary s = without(Monitor{}, m, grid, observer, straight_on);
  ASSERT_TRUE(s.crossing);
  EXPECT_EQ(s.crossing->kind, SingularityCrossing::Kind::passed);
}

TEST(Monitors, OfContinuityTellsAJump) {
  const Model m = parallelogram();
  const TimeGrid grid{0, 0.01, 300};
  Discard observer;
  EXPECT_FALSE(without(Monitor::continuity, m, grid, observer).crossing);
  EXPECT_TRUE(without(Monitor{}, m, grid, observer).crossing);
}

TEST(Monitors, OfResidualsTellWhatATolerancePermits) {
  const Scene scene = library_scene("slider_crank");
  const Model m = make_model(scene);
  const TimeGrid grid{scene.grid.start, scene.grid.step, 100};
  const Reference reference = make_reference(m, sampled(grid, 34));
  const auto unsaid = [&](Monitor monitor) {
    ErrorMeasure measure(m, reference.instants, reference.scales);
    const MonitoredSummary s = without(monitor, m, grid, measure, {.tolerance = 1e-6});
    return measure.error().position.max / s.bound.position;
  };
  EXPECT_GT(unsaid(Monitor::residual), 1000);
  EXPECT_LT(unsaid(Monitor{}), 1);
}

}  // namespace
}  // namespace desmo::run_test
