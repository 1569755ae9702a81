// Positions in which a mechanism could go on in two ways: passed smoothly, and flagged.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/checked/motions.h"
#include "tests/every_variant.h"

namespace desmo::change_points_test {
namespace {

using std::numbers::pi;

/// Crank OM = 1 and bar C–M with MC = 1; C slides on the x axis through O. The crank turns from 30°
/// at 30°/s, so that C is at x = 2 cos θ. At 90° (t = 2 s) C meets O: a change point, from which on
/// C could also rest at O.
void expect_scott_russell(const std::string& id, const TimeGrid& grid, Level level) {
  SCOPED_TRACE(id + ", level " + std::to_string(static_cast<int>(level)));
  const Model m = make_model(scene_file("scott_russell"));
  const CheckedRows r = solve_checked(m, grid, id, level);
  const CheckedSummary& s = r.summary;
  EXPECT_EQ(s.outcome(), Outcome::degraded) << describe(s, m);
  EXPECT_EQ(s.crossings, 1);
  EXPECT_EQ(s.flagged, 1);
  ASSERT_EQ(s.instants, grid.instants);
  ASSERT_TRUE(s.first_crossing);
  EXPECT_LT(s.first_crossing->after, 2);
  EXPECT_GT(s.first_crossing->before, 2);
  EXPECT_GE(s.first_crossing->time, 2);
  EXPECT_LT(s.first_crossing->time, 2 + grid.step);
  const int x = m.coordinate("C.x");
  const double rate = pi / 6;
  for (const CheckedRow& row : r.rows) {
    const double theta = pi / 6 + rate * row.time;
    const bool is_on_point = row.flag && row.flag->kind == RowFlag::Kind::on_point;
    EXPECT_TRUE(is_on_point || row.time != 2);
    if (is_on_point) EXPECT_NEAR(row.time, 2, 1e-2);
    EXPECT_NEAR(row.values.position[x], 2 * std::cos(theta), is_on_point ? 1e-7 : 1e-12);
    if (is_on_point) {
      for (const Level l : rate_levels)
        EXPECT_TRUE(std::ranges::all_of(row.values[l], [](double v) { return std::isnan(v); }));
      continue;
    }
    const double qd = -2 * rate * std::sin(theta), qdd = -2 * rate * rate * std::cos(theta);
    if (level >= Level::velocity) EXPECT_NEAR(row.values.velocity[x], qd, 1e-9) << row.time;
    if (level >= Level::acceleration)
      EXPECT_NEAR(row.values.acceleration[x], qdd, 1e-7) << row.time;
  }
}

EVERY_VARIANT(ChangePointOfEvery);

TEST_P(ChangePointOfEvery, PassesAChangePointSmoothly) {
  expect_scott_russell(GetParam().id, {0, 1. / 16, 81}, Level::acceleration);
  if (DESMO_SANITIZED) return;
  expect_scott_russell(GetParam().id, {0.01, 1. / 15, 70}, Level::acceleration);
}

TEST(ChangePoints, ArePassedWhateverIsAskedForAndHoweverStepsAreTaken) {
  for (const Level level : all_levels)
    for (const char* id :
         {"global_automatic_klu", "global_automatic_klu/jacobian:step",
          "block_symbolic_explicit/guess:hermite5", "group_symbolic_inlined/stride:4"})
      for (const TimeGrid& grid : {TimeGrid{0, 1. / 16, 81}, {0.01, 1. / 15, 70}, {0, 1, 6}}) {
        if (DESMO_SANITIZED && grid.instants > 6) continue;
        expect_scott_russell(id, grid, level);
      }
}

/// Expects the rocker of a parallelogram to stay parallel to its crank.
CheckedSummary expect_parallel(const Motion& crank, const TimeGrid& grid, const char* id) {
  SCOPED_TRACE(id);
  const Model m = make_model(parallelogram(crank, grid));
  const CheckedRows r = solve_checked(m, grid, id);
  EXPECT_EQ(r.summary.instants, grid.instants) << describe(r.summary, m);
  const int theta = m.coordinate("crank/theta"), psi = m.coordinate("dyad1/psi");
  for (const CheckedRow& row : r.rows) {
    if (row.flag && row.flag->kind == RowFlag::Kind::on_point) continue;
    for (const Level level : all_levels)
      EXPECT_NEAR(row.values[level][theta], row.values[level][psi],
                  row.radius[level][theta] + row.radius[level][psi])
          << row.time;
  }
  return r.summary;
}

/// The way back leads past the point again.
TEST(ChangePoints, ArePassedWhereDriversTurnBackBeyondThem) {
  for (const double beyond : {0.01, 0.09, 0.7, 1.}) {
    SCOPED_TRACE(beyond);
    const double fall = 0.9 + beyond;  // from its largest angle, at 1 s
    const CheckedSummary s = expect_parallel(Polynomial{{pi - 0.9, 2 * fall, -fall}},
                                             {0, 1. / 8, 17}, "global_automatic_klu");
    EXPECT_EQ(s.crossings, 2);
    EXPECT_EQ(s.flagged, 2);
  }
}

TEST(ChangePoints, AreNotWhereAMotionTurnsBackNextToThem) {
  for (const double left : {1e-3, 1e-6}) {
    const CheckedSummary s = expect_parallel(HarmonicSum{pi - 0.5 - left, {{0.5, pi, pi / 2}}},
                                             {0, 1. / 64, 129}, "global_automatic_klu");
    EXPECT_EQ(s.outcome(), Outcome::converged) << left;
    EXPECT_GT(s.condition, 0.1 / left);
  }
}

/// Bennett's linkage, drawn on the other side of where the equations that are kept for that drawing
/// are singular and all equations are not. No row is wrong without a flag.
TEST(ChangePoints, OfKeptEquationsAloneLeadNobodyAstray) {
  const std::vector<ExtremeCase> cases = extremes::redundant(Extent::brief);
  const auto of = [&](const char* name) {
    return std::ranges::find(cases, name, &ExtremeCase::name)->scene;
  };
  const Scene from_there = of("Bennett's mechanism from there");
  Scene elsewhere = of("Bennett's mechanism past there");
  elsewhere.motions = from_there.motions;
  for (const char* id :
       {"global_automatic_klu", "group_automatic_lapack", "block_automatic_eigen"}) {
    const CheckedRows expected = solve_checked(make_model(from_there), from_there.grid, id),
                      found = solve_checked(make_model(elsewhere), elsewhere.grid, id);
    EXPECT_EQ(expected.summary.outcome(), Outcome::converged) << id;
    ASSERT_EQ(found.rows.size(), expected.rows.size()) << id;
    for (std::size_t i = 0; i < found.rows.size(); ++i)
      for (const Level level : all_levels)
        for (std::size_t k = 0; !found.rows[i].flag && k < found.rows[i].values[level].size(); ++k)
          EXPECT_NEAR(found.rows[i].values[level][k], expected.rows[i].values[level][k], 1e-10);
  }
}

}  // namespace
}  // namespace desmo::change_points_test
