// Intervals that cannot be assembled: where they end a run, and how it goes on after them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "formulations/verification/run/assembly_error.h"
#include "tests/checked/rows.h"
#include "tests/dead_point.h"
#include "tests/range/four_bar.h"

namespace desmo::gaps_test {
namespace {

/// A crank that is told to swing 0.1 rad beyond its dead point, of 0.6 rad.
const Model overswinging =
    locking_four_bar(HarmonicSum{dead_point - 0.5, {{0.6, 2 * std::numbers::pi, 0}}});
const double locked = std::asin(0.5 / 0.6) / (2 * std::numbers::pi);  // until 0.5 s less that
constexpr TimeGrid swing{0, 0.01, 101};

TEST(Gaps, EndARunThatSaysByHowMuchItLacks) {
  const Model& m = overswinging;
  const CheckedSummary s = solve_checked(m, swing, "group_symbolic_inlined").summary;
  EXPECT_EQ(s.outcome(), Outcome::failed);
  EXPECT_EQ(s.time, 0.16);
  ASSERT_TRUE(s.assembly_error);
  EXPECT_TRUE(is_length(s.assembly_error->kind));
  EXPECT_TRUE(m.constraints[s.assembly_error->constraint].name.starts_with("dyad1/"));
  // Coupler and rocker lack what is between the pin of the crank and 9 from the pivot.
  const double theta = sample(m.drivers[0].motion, s.time).position;
  const double lacking = std::hypot(8 - 2 * std::cos(theta), 2 * std::sin(theta)) - 9;
  EXPECT_GT(s.assembly_error->amount, lacking / 5);
  EXPECT_LT(s.assembly_error->amount, lacking);
}

TEST(Gaps, ArePassedAndLeadBackToTheBranchOfTheDrawing) {
  const Model& m = overswinging;
  for (const std::string id :
       {"global_automatic_klu", "group_symbolic_inlined", "group_symbolic_explicit",
        "global_automatic_klu/stride:2", "group_symbolic_explicit/stride:16"}) {
    const CheckedRows r = solve_checked(m, swing, id, Level::acceleration, {.past_failures = true});
    EXPECT_EQ(r.summary.outcome(), Outcome::degraded) << id;
    EXPECT_EQ(r.summary.flagged, 0) << id << ": " << describe(r.summary, m);
    ASSERT_EQ(r.summary.gaps.size(), 1u) << id;
    const Gap& gap = r.summary.gaps.front();
    EXPECT_TRUE(gap.ends);
    EXPECT_NEAR(gap.from, locked, 2e-9) << id;
    EXPECT_NEAR(gap.to, 0.5 - locked, 2e-9) << id;
    // A step is halved 24 times, and no more: each time costs a solution.
    const double halved = std::ldexp(swing.step, -24);
    EXPECT_NEAR(std::remainder(gap.from - 0.15, halved), 0, halved / 100) << id;
    EXPECT_GT(std::abs(std::remainder(gap.from - 0.15, 8 * halved)), halved / 100) << id;
    EXPECT_EQ(m.groups[gap.failure.group].name, "dyad1/SG-I");
    auto row = r.rows.begin();
    int interpolated = 0;
    for (int i = 0; i < swing.instants; ++i) {
      const double t = swing.time(i);
      if (t > locked && t < 0.5 - locked) continue;
      ASSERT_NE(row, r.rows.end()) << id;
      EXPECT_EQ(row->time, t) << id;
      const std::vector<double> exact =
          locking_four_bar(Polynomial{{sample(m.drivers[0].motion, t).position}}).estimate;
      for (int k = 0; k < m.coordinates(); ++k)
        EXPECT_NEAR(row->values.position[k], exact[k], 1e-9) << id << ", " << t;
      interpolated += row->interpolated;
      EXPECT_TRUE(t < locked || !row->interpolated) << id << ", " << t;
      ++row;
    }
    EXPECT_EQ(interpolated > 0, id.ends_with("stride:2"));  // the longer one fails at its first end
    EXPECT_EQ(row, r.rows.end()) << id;
  }
}

/// A tolerance of 1e-4 accepts positions that no exact one is near, up to some ms beyond the lock.
TEST(Gaps, EndWhereExactPositionsDoWhateverTheTolerance) {
  const Model& m = overswinging;
  for (const char* id : {"group_symbolic_klu/tolerance:1e-4", "global_automatic_klu/tolerance:1e-3",
                         "block_automatic_lapack/tolerance:1e-6"}) {
    const CheckedSummary s =
        solve_checked(m, swing, id, Level::acceleration, {.past_failures = true}).summary;
    ASSERT_EQ(s.gaps.size(), 1u) << id;
    EXPECT_NEAR(s.gaps[0].from, locked, 2e-9) << id;
    EXPECT_NEAR(s.gaps[0].to, 0.5 - locked, 2e-9) << id;
    EXPECT_TRUE(s.gaps[0].assembly_error) << id;
  }
}

/// A gap of all instants is a failure.
TEST(Gaps, MayLastUntilTheEnd) {
  for (const TimeGrid& grid : {TimeGrid{0, 0.01, 30}, {0.2, 0.01, 10}}) {
    const CheckedSummary s = solve_checked(overswinging, grid, "block_automatic_lapack",
                                           Level::position, {.past_failures = true})
                                 .summary;
    ASSERT_EQ(s.gaps.size(), 1u);
    EXPECT_FALSE(s.gaps[0].ends);
    EXPECT_EQ(s.instants, grid.start == 0 ? 16 : 0);
    EXPECT_EQ(s.outcome(), grid.start == 0 ? Outcome::degraded : Outcome::failed);
    EXPECT_EQ(describe(s, overswinging).starts_with("failed: "), grid.start > 0)
        << describe(s, overswinging);
  }
}

/// The output of a drag link makes its turns with the input, and less than half a turn beside it.
TEST(Gaps, OfAMechanismLeaveTheTurnsOfOthers) {
  const Scene scene = scene_file("lock_beside_drag_link");
  const Model m = make_model(scene);
  for (const char* id : {"group_symbolic_inlined", "global_automatic_klu"}) {
    const CheckedRows r =
        solve_checked(m, scene.grid, id, Level::acceleration, {.past_failures = true});
    // As long as those of the crank alone, of 50 at 45 from its slider's line.
    const double locks =
        std::asin(std::asin(45. / 50) / (80 * std::numbers::pi / 180)) / (2 * std::numbers::pi);
    ASSERT_EQ(r.summary.gaps.size(), 2u) << id;
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(r.summary.gaps[i].from, i / 2. + locks, 2e-9) << id;
      EXPECT_NEAR(r.summary.gaps[i].to, (i + 1) / 2. - locks, 2e-9) << id;
    }
    EXPECT_EQ(r.summary.instants, 11) << id;
    EXPECT_EQ(r.summary.flagged, 0) << id << ": " << describe(r.summary, m);
    double turned = 0;
    for (const CheckedRow& row : r.rows) {
      turned = row.values.position[m.coordinate("turn")];
      EXPECT_LT(std::abs(row.values.position[m.coordinate("out")] - turned), std::numbers::pi)
          << id << ", " << row.time;
    }
    EXPECT_GT(turned, 18) << id;
  }
}

/// The parallelogram is in line at 0.25 s, where no row is delivered.
TEST(Gaps, HideNoChangePointOfOthers) {
  const Scene scene = scene_file("lock_beside_parallelogram");
  const Model m = make_model(scene);
  const CheckedRows r = solve_checked(m, scene.grid, "group_automatic_lapack", Level::acceleration,
                                      {.past_failures = true});
  ASSERT_EQ(r.summary.gaps.size(), 1u);
  EXPECT_EQ(r.summary.crossings, 1) << describe(r.summary, m);
  for (const CheckedRow& row : r.rows) {
    ASSERT_EQ(row.flag.has_value(), row.index == 8) << row.time;  // the first one after the gap
    if (!row.flag) continue;
    EXPECT_EQ(row.flag->kind, RowFlag::Kind::crossing);
    EXPECT_NEAR(row.flag->after, 0.25, 1e-3);
    EXPECT_NEAR(row.flag->before, 0.25, 1e-3);
  }
}

/// The second of two four-bars locks before the first row is solved, the first one before the
/// stride ends: there it is solved first.
TEST(Gaps, NameTheGroupThatFailsAtTheirFirstRow) {
  const double start = dead_point - 0.05;
  Model m = range_test::four_bar({2, 3, 6, 8}, start, 1, 1, 2);
  m.drivers[0].motion = Polynomial{{start, 1}}, m.drivers[1].motion = Polynomial{{start, 10}};
  for (const char* id : {"group_automatic_lapack", "group_automatic_lapack/stride:16"}) {
    const CheckedSummary s = solve_checked(m, {0, 0.01, 33}, id).summary;
    EXPECT_EQ(s.outcome(), Outcome::failed) << id;
    EXPECT_EQ(s.time, 0.01) << id;
    EXPECT_EQ(m.groups.at(s.group).bodies,
              (std::vector<std::string>{"1dyad1/coupler", "1dyad1/rocker"}))
        << id;
  }
}

/// Ends are as accurate as time is, where its rounding is more than 1e-9 s.
TEST(Gaps, AreFoundAtLateTimes) {
  const double start = std::numbers::pi / 3;
  for (const double late : {1e5, 1e6, 1e9}) {
    Model m = locking_four_bar();
    m.drivers[0].motion = Polynomial{{start - late, 1}};
    const CheckedSummary s = solve_checked(m, {late, 0.5, 13}, "group_symbolic_inlined",
                                           Level::acceleration, {.past_failures = true})
                                 .summary;
    ASSERT_EQ(s.gaps.size(), 1u) << late;
    const double rounding = 2e-9 + 4 * late * 0x1p-53;
    EXPECT_NEAR(s.gaps[0].from - late, dead_point - start, rounding) << late;
    EXPECT_NEAR(s.gaps[0].to - late, 2 * std::numbers::pi - dead_point - start, rounding) << late;
  }
}

TEST(Gaps, AreNotWhereAPositionExists) {
  const Model m = locking_four_bar(Polynomial{{dead_point}});
  EXPECT_FALSE(find_assembly_error(m, m.state_of(m.estimate)));
}

}  // namespace
}  // namespace desmo::gaps_test
