// Drivers that are handed in at every step: what each kind of row gets.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <string>

#include "formulations/id.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/verification/monitor/live_run.h"
#include "tests/dead_point.h"
#include "tests/lanes_here.h"

namespace desmo::live_test {
namespace {

/// Values of the drivers at an instant that a formulation has solved.
struct Row {
  std::vector<double> z, zd, zdd;
  explicit Row(const Formulation& f) {
    for (const Driver& d : f.model().drivers) {
      const int i = f.model().entities[d.coordinate].first;
      z.push_back(f.q()[i]);
      zd.push_back(f.qd()[i]);
      zdd.push_back(f.qdd()[i]);
    }
  }
  LiveRow at(double t) const { return {t, z, zd, zdd}; }
};

bool same(std::span<const double> a, std::span<const double> b) { return std::ranges::equal(a, b); }

std::vector<std::string> ids() {
  std::vector<std::string> all{"global_automatic_klu", "group_automatic_lapack",
                               "block_symbolic_inlined/guess:adams8", "group_symbolic_explicit"};
  for (const int lanes : lanes_here())
    all.push_back("group_symbolic_explicit/guess:hermite5/lanes:" + std::to_string(lanes));
  return all;
}

// Monitored runs of known motions correct as live ones do.
TEST(LiveRun, GivesTheBitsOfTheKnownMotion) {
  int compared = 0, corrected = 0;  // rows
  for (const auto& [m, grid] : every_motion())
    for (const std::string& id : ids()) {
      SCOPED_TRACE(m.name + ", " + id);
      const Configuration c = parse_id(id);
      const auto known = make_formulation(*c.variant, m, c.settings);
      const OneMoreCorrection corrections(parts_of(*known));
      const auto live = make_formulation(*c.variant, m, c.settings);
      LiveRun run(*live);
      const int before = compared;
      for (int i = 0; i < std::min(grid.instants, 200); ++i) {
        const double t = grid.time(i);
        const Summary expected = i == 0 ? known->assemble(t) : known->step(t);
        if (!expected.ok() || expected.sub_steps > 0) break;
        const LiveSummary s = run.step(Row(*known).at(t));
        ASSERT_NE(s.outcome(), Outcome::failed) << t;
        EXPECT_EQ(s.iterations, expected.iterations);
        EXPECT_TRUE(same(live->q(), known->q()) && same(live->qd(), known->qd()) &&
                    same(live->qdd(), known->qdd()))
            << t;
        corrected += s.corrected;
        EXPECT_TRUE(s.corrected || (same(run.q(), known->q()) && same(run.qd(), known->qd()) &&
                                    same(run.qdd(), known->qdd())))
            << t;
        ++compared;
      }
      EXPECT_GT(compared, before + 50);
    }
  EXPECT_LT(corrected, compared / 40);
}

/// A four-bar that locks, driven by its crank.
class LockingRun : public testing::Test {
 protected:
  static LiveOptions steady() {
    LiveOptions options;
    options.scales = Scales{{1, 10, 100}, {1, 10, 100}};
    return options;
  }
  explicit LockingRun(const LiveOptions& options = steady()) : run(*formulation, options) {}

  LiveSummary step(double t, double angle, double rate = 0) {
    const std::vector<double> z{angle}, zd{rate}, zdd{0};
    return run.step({t, z, zd, zdd});
  }
  /// Positive where C is on the side of the line from B to D where it starts.
  double side() const {
    const double *b = &run.q()[at("crank/B")], *c = &run.q()[at("dyad1/C")];
    return (8 - b[0]) * (c[1] - b[1]) + b[1] * (c[0] - b[0]);
  }
  void expect_good_row(double t, double angle, int expected = 1) {
    EXPECT_EQ(run.time(), t);
    EXPECT_EQ(run.q()[crank], angle);
    // Rod and rocker have their lengths.
    const double *b = &run.q()[at("crank/B")], *c = &run.q()[at("dyad1/C")];
    EXPECT_NEAR(std::hypot(c[0] - b[0], c[1] - b[1]), 3, 1e-10);
    EXPECT_NEAR(std::hypot(c[0] - 8, c[1]), 6, 1e-10);
    EXPECT_GT(expected * side(), 0) << angle;
  }
  /// Wherever the crank jumps to: on the branch, or it is said.
  void follow_jumps() {
    int by_sub_steps = 0, in_vain = 0;
    for (double share = -0.99; share < 1; share += 0.03) {
      run.restart();
      for (int i = 0; i <= 20; ++i) {
        const double angle = start + i * (-0.9 * dead_point - start) / 20;
        ASSERT_EQ(step(i, angle).outcome(), Outcome::converged);
      }
      const LiveSummary s = step(20.001, share * dead_point);
      ASSERT_NE(s.outcome(), Outcome::failed) << share;
      EXPECT_LE(s.sub_steps, LiveOptions{}.max_sub_steps);
      by_sub_steps += s.sub_steps > 0;
      EXPECT_GE(side(), 0) << share;
      in_vain += s.crossing.has_value();
      expect_good_row(20.001, share * dead_point, 1);
    }
    EXPECT_GT(by_sub_steps, 0);
    EXPECT_LE(in_vain, 1);
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

TEST_F(LockingRun, DoesNotDeliverASingularPosition) {
  ASSERT_EQ(step(0, dead_point - 0.1).outcome(), Outcome::converged);
  EXPECT_EQ(step(1, dead_point).outcome(), Outcome::failed);
  expect_good_row(0, dead_point - 0.1);
  EXPECT_EQ(step(2, dead_point - 0.05).outcome(), Outcome::converged);
}

/// Near the dead point bounds grow as the inverse distance does, and its powers.
TEST_F(LockingRun, SaysWhatConditioningLeaves) {
  ASSERT_EQ(step(0, dead_point - 0.1, 1).outcome(), Outcome::converged);
  const LiveSummary near = step(1, dead_point - 1e-9, 1);
  EXPECT_EQ(near.outcome(), Outcome::degraded);
  EXPECT_TRUE(near.degraded);
  EXPECT_GT(near.assessment.condition, 1e4);
  EXPECT_GT(near.assessment.bound.acceleration, 1e-6);
}

class PositionsAlone : public LockingRun {
 protected:
  static LiveOptions positions() {
    LiveOptions options;
    options.level = Level::position;
    return options;
  }
  PositionsAlone() : LockingRun(positions()) {}
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
  EXPECT_EQ(step(1, dead_point - 1e-13).outcome(), Outcome::degraded);
}

class WithoutSubSteps : public LockingRun {
 protected:
  static LiveOptions none() {
    LiveOptions options = steady();
    options.max_sub_steps = 0;
    return options;
  }
  WithoutSubSteps() : LockingRun(none()) {}
};

TEST_F(WithoutSubSteps, FailsAtOnce) {
  ASSERT_EQ(step(0, start).outcome(), Outcome::converged);
  const LiveSummary s = step(1, dead_point + 0.1);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  EXPECT_EQ(s.sub_steps, 0);
}

/// The scales that bounds are relative to are the caller's.
TEST(LiveOptions, ScaleTheBounds) {
  const Model m = four_bar_model(3);
  const auto bound = [&](const LiveOptions& options) {
    const auto f = make_formulation(find_variant("group_symbolic_inlined"), m);
    EXPECT_TRUE(f->assemble(0.1).ok());
    const Row row(*f);
    LiveRun run(*f, options);
    return run.step(row.at(0)).assessment.bound;
  };
  const PerLevel<double> one = bound({.scales = Scales{{1, 1, 1}, {1, 1, 1}}}),
                         ten = bound({.scales = Scales{{1, 10, 100}, {1, 10, 100}}});
  EXPECT_NEAR(one.velocity / ten.velocity, 10, 1e-9);
  EXPECT_NEAR(one.acceleration / ten.acceleration, 100, 1e-9);
  EXPECT_THROW(bound({.scales = Scales{}}), std::invalid_argument);
  // Positions alone need no rates.
  const auto f = make_formulation(find_variant("group_symbolic_inlined"), m);
  LiveRun run(*f, {.level = Level::position});
  ASSERT_TRUE(f->assemble(0.1).ok());
  const Row row(*f);
  EXPECT_EQ(run.step({.time = 0, .z = row.z}).outcome(), Outcome::converged);
  EXPECT_TRUE(run.qd().empty());
  EXPECT_THROW(LiveRun(*f, {.levels = std::array{Level::position}}), std::invalid_argument);
}

/// Positions that others have rates next to are followed like these.
TEST(LiveRun, SolvesCoordinatesToLevelsOfTheirOwn) {
  const Model m = locking_four_bar();
  std::vector<Level> levels(m.coordinates(), Level::position);
  levels[m.entities[m.find("crank/theta")].first] = Level::acceleration;
  const auto f = make_formulation(find_variant("block_symbolic_inlined"), m);
  LiveRun run(*f, {.levels = levels});
  const std::vector<double> rate{1}, none{0};
  const double start = sample(m.drivers[0].motion, 0.0).position;
  for (int i = 0; i <= 50; ++i) {
    const std::vector<double> angle{start + 0.01 * i};
    EXPECT_EQ(run.step({0.01 * i, angle, rate, none}).outcome(), Outcome::converged) << i;
  }
}

TEST(LiveRun, NeedsAFormulationThatStepsThroughTime) {
  const Model m = four_bar_model(3);
  for (Settings settings :
       {Settings{.segments = 4}, Settings{.threads = 2}, Settings{.stride = 4}}) {
    if (!unavailable_reason(settings).empty()) continue;
    const auto f = make_formulation(find_variant("group_symbolic_explicit"), m, settings);
    EXPECT_NE(unsupported_live_reason(*f), "");
    EXPECT_THROW(LiveRun{*f}, std::invalid_argument);
  }
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A controller's loop. Times depend on the machine; what takes them does not.
TEST(LiveRun, SolvesEveryMillisecondAtOnce) {
  const Model m =
      make_model(make_scene(find_case("truck_suspension"), DESMO_SANITIZED ? 114 : 558));
  const int steps = DESMO_SANITIZED ? 2000 : 100'000;
  const auto f = make_formulation(find_variant("group_symbolic_explicit"), m);
  LiveRun run(*f);
  Row row(*f);
  long iterations = 0, sub_steps = 0;
  double worst = 0, sum = 0;  // s
  for (int i = 0; i <= steps; ++i) {
    const double t = 1e-3 * i;
    for (std::size_t d = 0; d < m.drivers.size(); ++d) {
      const MotionSample<double> z = sample(m.drivers[d].motion, t);
      row.z[d] = z.position, row.zd[d] = z.velocity, row.zdd[d] = z.acceleration;
    }
    const double before = cpu_seconds();
    const LiveSummary s = run.step(row.at(t));
    const double taken = cpu_seconds() - before;
    ASSERT_EQ(s.outcome(), Outcome::converged) << t;
    if (i == 0) continue;  // the assembly
    iterations = std::max(iterations, s.iterations);
    sub_steps = std::max(sub_steps, s.sub_steps);
    worst = std::max(worst, taken);
    sum += taken;
  }
  EXPECT_LE(iterations, 3);
  EXPECT_EQ(sub_steps, 0);
  std::cout << m.coordinates() << " coordinates, " << steps << " steps: worst " << 1e6 * worst
            << " us, mean " << 1e6 * sum / steps << " us of the processor\n";
}

}  // namespace
}  // namespace desmo::live_test
