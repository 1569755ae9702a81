// Drivers that are handed in at every step: what each kind of row gets.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/io/files.h"
#include "cases/mechanism/builder.h"
#include "formulations/id.h"
#include "formulations/verification/run/live_run.h"
#include "tests/checked/driver_row.h"
#include "tests/checked/rows.h"
#include "tests/flaps.h"
#include "tests/lanes_here.h"
#include "tests/mechanisms.h"
#include "tests/overconstrained.h"

namespace desmo::live_rows_test {
namespace {

std::vector<std::string> ids() {
  std::vector<std::string> all{"global_automatic_klu", "group_automatic_lapack",
                               "block_symbolic_inlined/guess:adams8", "group_symbolic_explicit"};
  for (const int lanes : lanes_here())
    all.push_back("group_symbolic_explicit/guess:hermite5/lanes:" + std::to_string(lanes));
  return all;
}

/// A row has one exact answer, which is within the radii of what each formulation delivers.
TEST(LiveRun, AnswersAreWithinTheirRadii) {
  for (const auto& [m, grid] : every_motion()) {
    PerLevel<std::vector<std::vector<double>>> first, first_radius;  // by row
    for (const std::string& id : ids()) {
      SCOPED_TRACE(m.name + ", " + id);
      const Configuration c = parse_id(id);
      const auto f = make_formulation(*c.variant, m, c.settings);
      LiveRun run(*f);
      const bool is_first = first.position.empty();
      for (int i = 0; i < std::min(grid.instants, DESMO_SANITIZED ? 3 : 40); ++i) {
        const LiveSummary s = run.step(DriverRow(m, grid.time(i)));
        ASSERT_EQ(s.outcome(), Outcome::converged) << describe(s, m);
        EXPECT_GE(s.condition, 1);
        EXPECT_EQ(s.path.end == PathEnd::same, i > 0);
        const PerLevel<std::span<const double>> values{run.q(), run.qd(), run.qdd()};
        for (const Level level : all_levels) {
          EXPECT_LT(s.radius[level], 1e-9);
          const std::vector<double>& radius = run.radius()[level];
          if (is_first) {
            first[level].emplace_back(values[level].begin(), values[level].end());
            first_radius[level].push_back(radius);
          }
          for (std::size_t k = 0; k < radius.size(); ++k) {
            const double difference = std::abs(values[level][k] - first[level][i][k]);
            EXPECT_LE(difference, (radius[k] + first_radius[level][i][k]) * (1 + 1e-15)) << k;
          }
        }
      }
    }
  }
}

/// A Scott Russell linkage whose rods meet at a quarter turn, where branches meet.
TEST(LiveRun, RefusesRowsBeyondAChangePoint) {
  const Model m = make_model(scene_file("scott_russell"));
  const auto f = make_formulation(find_variant("block_symbolic_inlined"), m);
  LiveRun run(*f);
  const std::vector<double> rate{0.5}, none{0};
  const auto step = [&](double t, double angle) {
    const std::vector<double> z{angle};
    return run.step({t, z, rate, none});
  };
  ASSERT_EQ(step(0, 1.3).outcome(), Outcome::converged);
  ASSERT_EQ(step(0.2, 1.4).outcome(), Outcome::converged);
  const LiveSummary beyond = step(0.8, 1.7);
  EXPECT_EQ(beyond.outcome(), Outcome::failed);
  EXPECT_TRUE(beyond.is_unreached());
  EXPECT_EQ(run.time(), 0.2);
  EXPECT_EQ(step(0.8, 1.5).outcome(), Outcome::converged);
  // The way there from the drawing passes it, which the first row says.
  run.restart();
  for (int i = 0; i < 3; ++i) {
    const LiveSummary s = step(i, 1.7 + 0.1 * i);
    ASSERT_EQ(s.flag.has_value(), i == 0);
    if (s.flag) {
      EXPECT_EQ(s.flag->kind, RowFlag::Kind::crossing);
    }
  }
  run.restart();
  EXPECT_EQ(step(0, 1.3).outcome(), Outcome::converged);
}

/// Three parallel cranks move a coupler; one that is longer contradicts the others once they turn.
/// A flap's own shape is longer than its hinge on the ground.
TEST(LiveRun, FlagsRowsWhoseEquationsContradictEachOther) {
  struct Row {
    Scene scene;
    const char* id;
    int first;           // row that is flagged
    double least, most;  // misfits [m]
  };
  for (const auto& [scene, id, first, least, most] : std::vector<Row>{
           {parallel_cranks(1, 17, false, 0), "block_symbolic_inlined", 5, 0, 0},
           {parallel_cranks(1, 17, false, 2e-7), "block_symbolic_inlined", 1, 1e-11, 2e-7},
           {parse_scene(flaps(1, 4e-7), "flaps.json", ""), "group_automatic_lapack", 0,
            4e-7 - 1e-10, 4e-7 + 1e-10}}) {
    const Model m = make_model(scene);
    const auto f = make_formulation(find_variant(id), m);
    LiveRun run(*f);
    for (int i = 0; i < 5; ++i) {
      const LiveSummary s = run.step(DriverRow(m, 0.02 * i));
      EXPECT_EQ(s.outcome(), i < first ? Outcome::converged : Outcome::degraded) << m.name << i;
      if (!s.flag) continue;
      EXPECT_EQ(s.flag->kind, RowFlag::Kind::misfit);
      EXPECT_GT(s.flag->misfit->amount, least);
      EXPECT_LT(s.flag->misfit->amount, most);
    }
  }
}

/// Nothing has a size before anything moves.
TEST(LiveRun, StartsAtRest) {
  for (const auto& [m, grid] : every_motion()) {
    const auto f = make_formulation(find_variant("block_symbolic_inlined"), m);
    LiveRun run(*f);
    DriverRow row(m, grid.start);
    for (auto* rates : {&row.zd, &row.zdd}) std::ranges::fill(*rates, 0.0);
    const LiveSummary s = run.step(row);
    EXPECT_EQ(s.outcome(), Outcome::converged) << m.name << ": " << describe(s, m);
    EXPECT_EQ(s.radius.velocity, 0) << m.name;
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

/// A row that turns the crank once is followed. To follow twenty turns would take the time of
/// hundreds of proofs, which no controller has: that row is refused after 65.
TEST(LiveRun, RefusesWhatWouldTakeTooLong) {
  const Model m = four_bar_model(1);
  const auto f = make_formulation(find_variant("group_automatic_eigen"), m);
  LiveRun run(*f);
  const DriverRow first(m, 0);
  for (const int turns : {1, 20}) {
    run.restart();
    ASSERT_EQ(run.step(first).outcome(), Outcome::converged);
    DriverRow row(m, 1);
    row.z[0] = first.z[0] + 2 * std::numbers::pi * turns;
    const LiveSummary s = run.step(row);
    EXPECT_EQ(s.outcome(), turns == 1 ? Outcome::converged : Outcome::failed) << describe(s, m);
    EXPECT_LE(s.path.tests, 65);
    EXPECT_EQ(s.is_unreached(), turns == 20);
  }
}

/// The first row is assembled with the turns that lead to it from the drawing, whatever motions the
/// model has: they are at 1000 rad and at 0 rad.
TEST(LiveRun, CountsTheTurnsOfTheFirstRowWithoutChecks) {
  MechanismBuilder builder("gears", 2);
  const int o = builder.point("O", {0, 0}), a = builder.point("A", {1, 0}),
            b = builder.point("B", {0, 1}), p = builder.point("P", {3, 0}),
            c = builder.point("C", {4, 0});
  builder.carry(MechanismBuilder::ground, {o, p});
  const int crank = builder.body("crank", {o, a, b}), wheel = builder.body("wheel", {p, c});
  builder.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, crank, {o});
  builder.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, wheel, {p});
  builder.angle("a", {-1, o, a}).driven = true;
  builder.angle("b", {-1, o, b});
  builder.angle("c", {-1, p, c});
  builder.couple("gears", {{1, 1}, {2, -2}});
  const Model m = model_mechanism(builder.release(), {Polynomial{{0, 1}}}).model;
  const auto f = make_formulation(find_variant("group_automatic_lapack"), m);
  LiveRun run(*f, {.level = Level::position, .check = CheckMode::none});
  for (const auto& [time, angle] : {std::pair(1000., 0.1), {0., 100.1}}) {
    run.restart();
    ASSERT_EQ(run.step({time, std::span(&angle, 1)}).outcome(), Outcome::converged);
    EXPECT_NEAR(m.value("c", run.q()), angle / 2, 1e-9);
  }
}

/// A controller's loop: no row takes more than a step, and one test of its path.
TEST(LiveRun, ProvesEveryMillisecondAtOnce) {
  const Model m =
      make_model(make_scene(find_case("truck_suspension"), DESMO_SANITIZED ? 114 : 558));
  const auto f = make_formulation(find_variant("group_symbolic_explicit"), m);
  LiveRun run(*f);
  for (int i = 0; i <= (DESMO_SANITIZED ? 20 : 500); ++i) {
    const LiveSummary s = run.step(DriverRow(m, 1e-3 * i));
    ASSERT_EQ(s.outcome(), Outcome::converged) << i;
    if (i == 0) continue;  // the assembly
    EXPECT_LE(s.iterations, 3);
    EXPECT_EQ(s.sub_steps, 0);
    EXPECT_EQ(s.path.tests, 1);
  }
}

}  // namespace
}  // namespace desmo::live_rows_test
