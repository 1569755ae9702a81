// Drivers that are handed in at every step to a four-bar that locks: every row that is delivered
// continues the motion.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "formulations/motion/internals.h"
#include "formulations/variants.h"
#include "formulations/verification/run/live_run.h"
#include "tests/dead_point.h"

namespace desmo::live_locking_test {
namespace {

/// A four-bar that locks, driven by its crank.
class LockingRun : public testing::Test {
 protected:
  static constexpr Scales steady{{1, 10, 100}, {1, 10, 100}};

  explicit LockingRun(const LiveOptions& options = {.scales = steady})
      : run(*formulation, options) {}

  LiveSummary step(double t, double angle, double rate = 0) {
    const std::vector<double> z{angle}, zd{rate}, zdd{0};
    return run.step({t, z, zd, zdd});
  }
  /// Positive where C is on the side of the line from B to D where it starts.
  double side() const {
    const double *b = &run.q()[at("crank/B")], *c = &run.q()[at("dyad1/C")];
    return (8 - b[0]) * (c[1] - b[1]) + b[1] * (c[0] - b[0]);
  }
  void expect_good_row(double t, double angle) {
    EXPECT_EQ(run.time(), t);
    EXPECT_EQ(run.q()[crank], angle);
    // Rod and rocker have their lengths.
    const double *b = &run.q()[at("crank/B")], *c = &run.q()[at("dyad1/C")];
    EXPECT_NEAR(std::hypot(c[0] - b[0], c[1] - b[1]), 3, 1e-14);
    EXPECT_NEAR(std::hypot(c[0] - 8, c[1]), 6, 1e-14);
    EXPECT_GT(side(), 0) << angle;
  }
  /// Wherever the crank jumps to, the answer is on the branch.
  void follow_jumps() {
    int in_sub_steps = 0;
    for (double share = -0.99; share < 1; share += DESMO_SANITIZED ? 0.3 : 0.03) {
      run.restart();
      for (int i = 0; i <= 20; ++i) {
        const double angle = start + i * (-0.9 * dead_point - start) / 20;
        ASSERT_EQ(step(i, angle).outcome(), Outcome::converged);
      }
      const LiveSummary s = step(20.001, share * dead_point);
      ASSERT_EQ(s.outcome(), Outcome::converged) << share << ": " << describe(s, m);
      EXPECT_LE(s.sub_steps, LiveOptions{}.max_sub_steps);
      EXPECT_LE(s.path.tests, LiveOptions{}.max_sub_steps + 1);
      in_sub_steps += s.path.sub_steps > 1;
      expect_good_row(20.001, share * dead_point);
    }
    EXPECT_GT(in_sub_steps, DESMO_SANITIZED ? 3 : 30);
  }
  int at(const char* name) const { return m.entities[m.find(name)].first; }

  const Model m = locking_four_bar();
  const std::unique_ptr<Formulation> formulation =
      make_formulation(find_variant("group_automatic_eigen"), m);
  const int crank = at("crank/theta");
  const double start = sample(m.drivers[0].motion, 0.0).position;
  LiveRun run;
};

TEST_F(LockingRun, RefusesARowThatCannotBeMeant) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(step(0, nan).fault, RowFault::not_finite);
  EXPECT_FALSE(run.has_position());
  ASSERT_EQ(step(1, start).outcome(), Outcome::converged);
  const std::vector<double> one{start}, two{start, start};
  for (const auto& [row, fault] : std::initializer_list<std::pair<LiveRow, RowFault>>{
           {{2, {}, one, one}, RowFault::wrong_size},
           {{2, one, one, two}, RowFault::wrong_size},
           {{nan, one, one, one}, RowFault::not_finite},
           {{1, one, one, one}, RowFault::time_not_later},
           {{0.5, one, one, one}, RowFault::time_not_later}}) {
    const LiveSummary s = run.step(row);
    EXPECT_EQ(s.outcome(), Outcome::failed);
    EXPECT_EQ(s.fault, fault);
    EXPECT_TRUE(describe(s, m).starts_with("refused: ")) << describe(s, m);
    EXPECT_EQ(s.iterations, 0);
    expect_good_row(1, start);
  }
  EXPECT_EQ(step(2, start, INFINITY).fault, RowFault::not_finite);
  EXPECT_EQ(step(2, start + 0.01).outcome(), Outcome::converged);
  run.set_time(0);
  EXPECT_EQ(step(1, start).outcome(), Outcome::converged);
  expect_good_row(1, start);
}

TEST_F(LockingRun, FollowsAJump) { follow_jumps(); }

/// Wherever the formulation ends, the answer continues the motion, and so does the formulation.
TEST_F(LockingRun, LeadsTheFormulationBackToTheBranch) {
  ASSERT_EQ(step(0, start).outcome(), Outcome::converged);
  const std::vector<double> mirrored =
      on_other_branch(m, {run.q().begin(), run.q().end()}, "crank/B", "dyad1");
  stepping_of(*formulation).return_to(mirrored, 0);
  const LiveSummary led = step(1, start + 0.1);
  EXPECT_EQ(led.outcome(), Outcome::converged);
  EXPECT_EQ(led.path.end, PathEnd::other);
  expect_good_row(1, start + 0.1);
  const LiveSummary next = step(2, start + 0.2);
  EXPECT_EQ(next.path.end, PathEnd::same);
  expect_good_row(2, start + 0.2);
}

TEST_F(LockingRun, StaysAtTheLastGoodRowWhereNoneCanBeReached) {
  const LiveSummary first = step(0, 3);
  EXPECT_EQ(first.outcome(), Outcome::failed);
  EXPECT_FALSE(run.has_position());
  ASSERT_EQ(step(0, start).outcome(), Outcome::converged);
  for (int i = 1; i <= 3; ++i) {
    const LiveSummary s = step(i, dead_point + 0.1 * i);
    EXPECT_EQ(s.outcome(), Outcome::failed);
    EXPECT_NE(s.status, Status::solved);
    EXPECT_LE(s.sub_steps, LiveOptions{}.max_sub_steps);
    EXPECT_EQ(m.groups[s.group].name, "dyad1/SG-I");
    EXPECT_TRUE(s.is_unreached());
    EXPECT_GT(s.path.time, 0);
    EXPECT_LT(s.path.time, i);
    expect_good_row(0, start);
    const LiveRun::Obstacle obstacle = run.explain();
    EXPECT_EQ(m.groups[obstacle.group].name, "dyad1/SG-I");
    ASSERT_TRUE(obstacle.assembly_error);
    EXPECT_GT(obstacle.assembly_error->amount, 1e-3);
  }
  const LiveSummary back = step(4, start + 0.2);
  EXPECT_EQ(back.outcome(), Outcome::converged);
  expect_good_row(4, start + 0.2);
}

/// The crank locks on its way to a position that exists.
TEST_F(LockingRun, RefusesWhatNoMotionLeadsTo) {
  ASSERT_EQ(step(0, dead_point - 0.05).outcome(), Outcome::converged);
  const double beyond = 2 * std::numbers::pi - dead_point + 0.05;
  const LiveSummary s = step(1, beyond);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  EXPECT_TRUE(s.is_unreached());
  EXPECT_LT(s.path.time, 1);
  EXPECT_NE(describe(s, m).find("not proven beyond t = 0."), std::string::npos) << describe(s, m);
  expect_good_row(0, dead_point - 0.05);
}

TEST_F(LockingRun, DoesNotDeliverASingularPosition) {
  ASSERT_EQ(step(0, dead_point - 0.1).outcome(), Outcome::converged);
  EXPECT_EQ(step(1, dead_point).outcome(), Outcome::failed);
  expect_good_row(0, dead_point - 0.1);
  EXPECT_EQ(step(2, dead_point - 0.05).outcome(), Outcome::converged);
}

/// Near the dead point radii grow as the inverse distance does, and its powers.
TEST_F(LockingRun, SaysWhatConditioningLeaves) {
  ASSERT_EQ(step(0, dead_point - 0.1, 1).outcome(), Outcome::converged);
  const LiveSummary near = step(0.1, dead_point - 1e-6, 1);
  EXPECT_EQ(near.outcome(), Outcome::converged) << describe(near, m);
  EXPECT_GT(near.condition, 1e3);
  EXPECT_GT(near.path.sub_steps, 3);
}

TEST_F(LockingRun, StartsOnTheBranchOfTheDrawing) {
  for (const double angle : {-0.95 * dead_point, 0.99 * dead_point, 0.0}) {
    run.restart();
    EXPECT_EQ(step(0, angle).outcome(), Outcome::converged) << angle;
    expect_good_row(0, angle);
  }
}

class PositionsAlone : public LockingRun {
 protected:
  PositionsAlone() : LockingRun({.level = Level::position}) {}
};

TEST_F(PositionsAlone, FollowsAJump) { follow_jumps(); }

/// Rows that turn back, or rest, next to the dead point are neither flagged nor leave the branch.
TEST_F(PositionsAlone, TurnsBackNextToADeadPoint) {
  for (int i = 0; i <= 40; ++i) {
    const double angle = (dead_point - 1e-3) * std::cos(0.25 * i);
    EXPECT_EQ(step(0.01 * i, angle).outcome(), Outcome::converged) << i;
    expect_good_row(0.01 * i, angle);
  }
  for (const double angle : {0.5, dead_point - 1e-2, dead_point - 1e-2, 0.5}) {
    const double next = run.time() + 0.01;
    EXPECT_EQ(step(next, angle).outcome(), Outcome::converged) << angle;
    expect_good_row(next, angle);
  }
}

class WithoutSubSteps : public LockingRun {
 protected:
  WithoutSubSteps() : LockingRun({.scales = steady, .max_sub_steps = 0}) {}
};

TEST_F(WithoutSubSteps, FailsAtOnce) {
  ASSERT_EQ(step(0, start).outcome(), Outcome::converged);
  for (const double angle : {dead_point + 0.1, -0.9 * dead_point}) {
    const LiveSummary s = step(1, angle);
    EXPECT_EQ(s.outcome(), Outcome::failed) << angle;
    EXPECT_EQ(s.sub_steps, 0);
    EXPECT_EQ(s.path.tests, 1);
    expect_good_row(0, start);
  }
}

class WithoutChecks : public LockingRun {
 protected:
  WithoutChecks() : LockingRun({.scales = steady, .check = CheckMode::none}) {}
};

TEST_F(WithoutChecks, ProvesNothing) {
  ASSERT_EQ(step(0, start).outcome(), Outcome::converged);
  const LiveSummary s = step(1, start + 0.1);
  EXPECT_EQ(s.outcome(), Outcome::converged);
  EXPECT_EQ(s.condition, 0);
  EXPECT_EQ(s.path.tests, 0);
  EXPECT_TRUE(std::isinf(run.radius().position[crank]));
  EXPECT_EQ(run.q()[crank], start + 0.1);
  EXPECT_TRUE(std::ranges::equal(run.q(), formulation->q()));
  EXPECT_EQ(step(2, 3).outcome(), Outcome::failed);
  EXPECT_EQ(run.time(), 1);
}

}  // namespace
}  // namespace desmo::live_locking_test
