// Whole checked runs: what they hand on, how they end, and what their summaries say.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "formulations/model/plan.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/checked/rows.h"
#include "tests/dead_point.h"

namespace desmo::run_test {
namespace {

constexpr const char* ids[] = {"global_automatic_klu", "group_symbolic_inlined",
                               "group_symbolic_explicit"};

TEST(CheckedRun, ProvesOrdinaryMotions) {
  for (const auto& [m, grid] : every_motion())
    for (const char* id : {ids[0], ids[2]}) {
      const TimeGrid begin{grid.start, grid.step,
                           std::min(grid.instants, DESMO_SANITIZED ? 10 : 100)};
      const CheckedSummary s = solve_checked(m, begin, id).summary;
      EXPECT_EQ(s.outcome(), Outcome::converged) << m.name << ", " << id << ": " << describe(s, m);
      EXPECT_TRUE(describe(s, m).starts_with("converged: ")) << describe(s, m);
      EXPECT_EQ(s.instants, begin.instants);
      EXPECT_LT(s.radius.position, 1e-13) << m.name;
    }
}

TEST(CheckedRun, ProvesWhatIsFixed) {
  Model m;
  m.add_fixed(EntityKind::point, "A", std::vector<double>{1, 2});
  for (const char* id : ids) {
    const CheckedSummary s = solve_checked(m, {0, 1, 3}, id).summary;
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_EQ(s.instants, 3) << id;
  }
}

TEST(CheckedRun, RefusesWhatItCannotCheck) {
  const Model m = locking_four_bar();
  const auto f = make_formulation(find_variant(ids[0]), m);
  RowCount rows;
  const std::vector<int> first{0};
  EXPECT_THROW(static_cast<void>(run_checked(*f, {0, 0.1, 2}, {Level::position, first}, rows)),
               std::invalid_argument);
  const std::vector<Level> one(1);
  EXPECT_THROW(static_cast<void>(run_checked(*f, {0, 0.1, 2}, {}, rows, {.levels = one})),
               std::invalid_argument);
  const CheckOptions no_row{.mode = CheckMode::sample, .sample = 0};
  EXPECT_THROW(static_cast<void>(run_checked(*f, {0, 0.1, 2}, {}, rows, no_row)),
               std::invalid_argument);
  EXPECT_TRUE(rows.indices.empty());
}

TEST(CheckedRun, EndsWhereTheObserverDoes) {
  const Model m = locking_four_bar();
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit/stride:8"}) {
    const Configuration c = parse_id(id);
    RowCount rows(5);
    const CheckedSummary s =
        run_checked(*make_formulation(*c.variant, m, c.settings), {0, 1e-3, 100}, {}, rows);
    EXPECT_TRUE(s.stopped) << id;
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_EQ(s.instants, 6) << id;
    EXPECT_EQ(rows.indices, (std::vector{0, 1, 2, 3, 4, 5})) << id;
  }
}

TEST(CheckedRun, ProvesTheLevelsAskedForAlone) {
  const Scene scene = library_scene("slider_crank");
  const Model whole = make_model(scene);
  for (const Level level : all_levels) {
    const CheckedRows r = solve_checked(whole, {0, 0.01, 20}, ids[2], level);
    EXPECT_EQ(r.summary.outcome(), Outcome::converged);
    for (const Level l : all_levels) {
      EXPECT_EQ(r.rows[7].values[l].empty(), l > level);
      EXPECT_EQ(r.summary.radius[l] > 0, l <= level);
    }
  }
  // The slider's velocity, and so of all else the position at least.
  const Output outputs[] = {{whole.find("C"), Level::velocity}};
  const Plan plan = make_plan(whole, outputs);
  const Reference reference = make_reference(plan.model, std::vector{0., 0.1, 0.2});
  const CheckedRows r =
      solve_checked(plan.model, {0, 0.1, 3}, ids[0], plan.level(), {.levels = plan.levels});
  EXPECT_EQ(r.summary.outcome(), Outcome::converged);
  EXPECT_EQ(expect_within_radii(plan.model, r.rows, reference.instants), 3);
}

TEST(CheckedRun, ChecksNothingWithoutAMode) {
  const Model m = locking_four_bar();
  const auto f = make_formulation(find_variant(ids[0]), m);
  const auto g = make_formulation(find_variant(ids[0]), m);
  RowCount checked, plain;
  const CheckedSummary s = run_checked(*f, {0, 0.01, 9}, {}, checked, {.mode = CheckMode::none});
  ASSERT_TRUE(g->run({0, 0.01, 9}, {}, plain).ok());
  EXPECT_TRUE(std::ranges::equal(f->q(), g->q()));
  EXPECT_EQ(checked.indices, plain.indices);
  EXPECT_EQ(s.radius.position, 0);
}

/// Rows between samples lie in the path from one to the next, and have no radii.
TEST(CheckedRun, ProvesSamplesAndThePathBetweenThem) {
  const Scene scene = library_scene("rssr");
  const Model m = make_model(scene);
  const Reference reference = make_reference(m, sampled({0, 0.01, 11}, 11));
  for (const char* id : ids) {
    const CheckedRows r = solve_checked(m, {0, 0.01, 11}, id, Level::acceleration,
                                        {.mode = CheckMode::sample, .sample = 4});
    EXPECT_EQ(r.summary.outcome(), Outcome::converged) << id << ": " << describe(r.summary, m);
    ASSERT_EQ(r.rows.size(), 11u) << id;
    for (int i = 0; i < 11; ++i)
      EXPECT_EQ(r.rows[i].radius.position.empty(), i % 4 != 0 && i != 10) << id << ", " << i;
    for (const int i : {0, 4, 8, 10})
      EXPECT_EQ(expect_within_radii(m, {&r.rows[i], 1}, reference.instants), 1);
  }
  // A path of four radians is not proven at once: one by one, all are.
  const CheckedRows r = solve_checked(four_bar_model(1), {0, 1, 9}, ids[0], Level::acceleration,
                                      {.mode = CheckMode::sample, .sample = 4});
  EXPECT_EQ(r.summary.outcome(), Outcome::converged);
  for (const CheckedRow& row : r.rows) EXPECT_FALSE(row.radius.position.empty()) << row.time;
}

/// The rows since the last sample are handed on after the run has failed at a later one.
TEST(CheckedRun, StopsAtARowBetweenSamplesBeforeAFailure) {
  const Model m = locking_four_bar();
  const auto f = make_formulation(find_variant(ids[0]), m);
  const TimeGrid grid{0, 0.1, 20};  // the dead point is between its rows 9 and 10
  RowCount all, stopping(9);
  const CheckOptions options{.mode = CheckMode::sample, .sample = 4};
  ASSERT_EQ(run_checked(*f, grid, {Level::position}, all, options).outcome(), Outcome::failed);
  EXPECT_EQ(all.indices.size(), 10u);
  const CheckedSummary s = run_checked(*f, grid, {Level::position}, stopping, options);
  EXPECT_TRUE(s.stopped);
  EXPECT_EQ(s.outcome(), Outcome::converged) << describe(s, m);
  EXPECT_EQ(stopping.indices.size(), 10u);
}

/// A crank that swings up to its dead point but for a little, and back.
Model swinging(double distance) {
  constexpr double amplitude = 0.5;
  return locking_four_bar(
      HarmonicSum{dead_point - distance - amplitude, {{amplitude, 2 * std::numbers::pi, 0}}});
}

TEST(CheckedRun, FlagsRowsTooNearADeadPointAndNoOthers) {
  for (const double distance : {1e-6, 1e-15})
    for (const char* id : ids) {
      const Model m = swinging(distance);
      const Reference reference = make_reference(m, std::vector{0.1, 0.249, 0.251});
      const CheckedRows r = solve_checked(m, {0, 1e-3, 501}, id);
      const CheckedSummary& s = r.summary;
      EXPECT_EQ(expect_within_radii(m, std::span(r.rows).first(250), reference.instants), 2);
      if (distance == 1e-6) {
        EXPECT_EQ(s.outcome(), Outcome::converged) << id << ": " << describe(s, m);
        EXPECT_GT(s.condition, 0.2 / std::sqrt(distance)) << id;
        continue;
      }
      EXPECT_NE(s.outcome(), Outcome::converged) << id;
      if (s.outcome() == Outcome::failed) continue;
      ASSERT_TRUE(s.first_flag);
      EXPECT_NEAR(s.first_flag->time, 0.25, 1.5e-3) << id;
      EXPECT_TRUE(describe(s, m).starts_with("degraded: " + std::to_string(s.flagged) + " rows"))
          << describe(s, m);
    }
}

/// A crank at rest that departs slowly: its velocity, which the run's scales begin with, is the
/// difference of two that cancel. At 80 ps the radius is a quarter of it, at 35 ps more than all.
TEST(CheckedRun, FlagsRatesWithoutADigit) {
  const Model m = locking_four_bar(HarmonicSum{1, {{0.375, 1, 0}, {-0.125, 3, 0}}});
  for (const double t : {80e-12, 35e-12}) {
    const CheckedSummary s = solve_checked(m, {t, 1, 1}, ids[0], Level::velocity).summary;
    EXPECT_EQ(s.flagged, t < 50e-12) << t;
    if (s.first_flag) EXPECT_EQ(s.first_flag->kind, RowFlag::Kind::unproven);
    if (!s.first_flag) EXPECT_GT(s.radius.velocity, 0.1);
  }
}

TEST(CheckedRun, StrictEndsAtTheFirstRowThatIsFlagged) {
  const Model m = swinging(1e-15);
  for (const char* id : ids) {
    const CheckedRows all = solve_checked(m, {0, 1e-3, 501}, id);
    const CheckedRows r =
        solve_checked(m, {0, 1e-3, 501}, id, Level::acceleration, {.strict = true});
    ASSERT_TRUE(r.summary.first_flag) << id;
    EXPECT_EQ(r.summary.outcome(), Outcome::failed) << id;
    EXPECT_TRUE(r.summary.refused) << id;
    EXPECT_EQ(r.summary.first_flag->time, all.summary.first_flag->time) << id;
    EXPECT_NEAR(r.summary.first_flag->time, 1e-3 * static_cast<double>(r.rows.size()), 1e-9);
    EXPECT_TRUE(describe(r.summary, m).starts_with("refused: ")) << describe(r.summary, m);
  }
}

}  // namespace
}  // namespace desmo::run_test
