// Options of live runs: scales, and levels that are solved.

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>
#include <vector>

#include "formulations/variants.h"
#include "formulations/verification/run/live_run.h"
#include "tests/checked/driver_row.h"
#include "tests/dead_point.h"

namespace desmo::live_options_test {
namespace {

/// The scales that radii are relative to are the caller's.
TEST(LiveOptions, ScaleTheRadii) {
  const Model m = four_bar_model(3);
  const auto f = make_formulation(find_variant("group_symbolic_inlined"), m);
  const auto radius = [&](const LiveOptions& options) {
    LiveRun run(*f, options);
    return run.step(DriverRow(m, 0.1)).radius;
  };
  const PerLevel<double> one = radius({.scales = Scales{{1, 1, 1}, {1, 1, 1}}}),
                         ten = radius({.scales = Scales{{1, 10, 100}, {1, 10, 100}}});
  EXPECT_NEAR(one.velocity / ten.velocity, 10, 1e-9);
  EXPECT_NEAR(one.acceleration / ten.acceleration, 100, 1e-9);
  EXPECT_THROW(radius({.scales = Scales{}}), std::invalid_argument);
  for (const CheckMode mode : {CheckMode::sample, CheckMode::mechanism})
    EXPECT_THROW(radius({.check = mode}), std::invalid_argument);
  // Positions alone need no rates.
  LiveRun run(*f, {.level = Level::position});
  const DriverRow row(m, 0.1);
  EXPECT_EQ(run.step({.time = 0, .z = row.z}).outcome(), Outcome::converged);
  EXPECT_TRUE(run.qd().empty());
  EXPECT_THROW(LiveRun(*f, {.levels = std::array{Level::position}}), std::invalid_argument);
}

/// A radius of half a scale leaves no digit. The caller's scales are such that this row's radius is
/// a fifth of one, or all of it.
TEST(LiveOptions, TellWhichRadiiLeaveNoDigit) {
  const Model m = four_bar_model(3);
  const auto f = make_formulation(find_variant("group_symbolic_inlined"), m);
  const auto step = [&](double scale) {
    const PerLevel<double> scales{scale, 1, 1};
    LiveRun run(*f, {.level = Level::position, .scales = Scales{scales, scales}});
    return run.step(DriverRow(m, 0.1));
  };
  const double radius = step(1).radius.position;
  for (const double share : {0.2, 1.}) {
    const LiveSummary s = step(radius / share);
    EXPECT_NEAR(s.radius.position, share, 1e-9);
    EXPECT_EQ(s.outcome(), share < 0.5 ? Outcome::converged : Outcome::degraded) << share;
    if (s.flag) EXPECT_EQ(s.flag->kind, RowFlag::Kind::unproven);
  }
}

/// The largest number of sub-steps leaves the proofs a budget, too.
TEST(LiveOptions, AllowAnyNumberOfSubSteps) {
  const Model m = four_bar_model(1);
  const auto f = make_formulation(find_variant("group_automatic_eigen"), m);
  LiveRun run(*f, {.max_sub_steps = std::numeric_limits<int>::max()});
  for (const double t : {0.1, 0.2}) {
    const LiveSummary s = run.step(DriverRow(m, t));
    EXPECT_EQ(s.outcome(), Outcome::converged) << t << ": " << describe(s, m);
  }
}

/// The next row is the first one again.
TEST(LiveRun, TakesNoScaleFromRowsBeforeARestart) {
  const Model m = four_bar_model(1);
  const auto f = make_formulation(find_variant("group_automatic_eigen"), m);
  LiveRun run(*f);
  const Scales before = run.scales();
  ASSERT_EQ(run.step(DriverRow(m, 0.1)).outcome(), Outcome::converged);
  EXPECT_NE(run.scales().rotation, before.rotation);
  run.restart();
  EXPECT_EQ(run.scales().length, before.length);
  EXPECT_EQ(run.scales().rotation, before.rotation);
}

/// On a dead point, rates are those that rounding leaves.
TEST(LiveRun, TakesNoScaleFromARowWithoutProof) {
  const Model m = locking_four_bar();
  const auto f = make_formulation(find_variant("group_automatic_eigen"), m);
  LiveRun run(*f);
  const double before = run.scales().length.velocity, rate = 1, none = 0;
  const LiveSummary s = run.step({0, {&dead_point, 1}, {&rate, 1}, {&none, 1}});
  ASSERT_TRUE(s.flag && s.flag->kind == RowFlag::Kind::unproven) << describe(s, m);
  EXPECT_EQ(run.scales().length.velocity, before);
}

/// Velocities alone go along the cubic.
TEST(LiveRun, AnswersRowsUpToVelocities) {
  for (const auto& [m, grid] : every_motion()) {
    const auto f = make_formulation(find_variant("block_symbolic_inlined"), m);
    LiveRun run(*f, {.level = Level::velocity});
    for (int i = 0; i < (DESMO_SANITIZED ? 3 : 20); ++i) {
      const DriverRow row(m, grid.time(i));
      const LiveSummary s = run.step({row.time, row.z, row.zd});
      ASSERT_EQ(s.outcome(), Outcome::converged) << m.name << ": " << describe(s, m);
      EXPECT_LE(s.path.sub_steps, 2) << m.name;
      EXPECT_LT(s.radius.velocity, 1e-9);
    }
  }
}

/// Positions that others have rates next to are followed like these.
TEST(LiveRun, SolvesCoordinatesToLevelsOfTheirOwn) {
  const Model m = locking_four_bar();
  std::vector<Level> levels(m.coordinates(), Level::position);
  levels[m.entities[m.find("crank/theta")].first] = Level::acceleration;
  const auto f = make_formulation(find_variant("block_symbolic_inlined"), m);
  LiveRun run(*f, {.levels = levels});
  for (int i = 0; i <= 50; ++i) {
    const LiveSummary s = run.step(DriverRow(m, 0.01 * i));
    EXPECT_EQ(s.outcome(), Outcome::converged) << i << ": " << describe(s, m);
  }
}

}  // namespace
}  // namespace desmo::live_options_test
