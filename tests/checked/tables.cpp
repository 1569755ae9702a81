// Couplings by tables: what contradicts between rows, knots on change points, whole turns, and
// motions that lock where a table has an extremum.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases/io/files.h"
#include "formulations/verification/run/live_run.h"
#include "tests/checked/rows.h"
#include "tests/everything.h"
#include "tests/wheel.h"

namespace desmo::tables_test {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

/// Two tables w = a [°], with the same values each 4°. The second has a bump of that height between
/// them, at 178°; what it leaves beside it falls 4-fold from knot to knot.
std::string tables_that_part(double bump) {
  std::vector<double> at, values, more_at, more;
  for (int a = -40; a <= 400; a += 2) {
    if (a % 4 == 0) at.push_back(a), values.push_back(a);
    more_at.push_back(a), more.push_back(a == 178 ? a + bump : a);
  }
  return coupling_table("first", at, values) + ", " + coupling_table("second", more_at, more);
}

CheckedRows solve(const Wheel& wheel, const std::string& id = "group_automatic_lapack",
                  CheckOptions options = {}) {
  const Scene scene = wheel.scene();
  return solve_checked(make_model(scene), scene.grid, id, Level::acceleration, options);
}

/// Rows are at multiples of 2°, where both tables agree but for 178°, or of 4°, where they agree.
TEST(CouplingsByTable, AreFlaggedWhereTheyContradictBetweenRows) {
  for (const double bump : {0.5, 0.01})
    for (const double step : {0.05, 0.1, 0.2, 1.})
      for (const char* id : {"global_automatic_klu", "group_automatic_lapack/stride:4"}) {
        SCOPED_TRACE(id + std::to_string(step) + ", " + std::to_string(bump));
        const CheckedRows r =
            solve({.couplings = tables_that_part(bump), .end = 6, .step = step}, id);
        EXPECT_EQ(r.summary.outcome(), Outcome::degraded);
        ASSERT_TRUE(r.summary.misfit);
        EXPECT_NEAR(r.summary.misfit->amount, bump * degree, 0.4 * bump * degree);
        for (const CheckedRow& row : r.rows) {
          const double a = 40 * row.time;
          const bool is_after = a >= 178 && a - 40 * step < 178;
          if (is_after) {
            ASSERT_TRUE(row.flag && row.flag->kind == RowFlag::Kind::misfit) << a;
            if (a == 178)
              EXPECT_LE(row.flag->after, row.flag->time);
            else
              EXPECT_LT(row.flag->after, row.flag->time);
          }
          if (a < 60 || a > 178 + 120 + 40 * step) EXPECT_FALSE(row.flag) << a;
        }
      }
}

/// So do rows that are handed in.
TEST(CouplingsByTable, AreFlaggedWhereTheyContradictBetweenLiveRows) {
  const Model m = make_model(Wheel{.couplings = tables_that_part(0.5)}.scene());
  const auto f = make_formulation(find_variant("group_automatic_lapack"), m);
  LiveRun run(*f, {.level = Level::velocity});
  for (int row = 0; row < 8; ++row) {
    const double z = 32 * degree * row, zd = 320 * degree, beyond = 460 * degree;
    if (row == 2)  // the misfit of a way that leads to no row is not that of the next one
      EXPECT_EQ(run.step({0.1 * row, {&beyond, 1}, {&zd, 1}}).outcome(), Outcome::failed);
    const LiveSummary s = run.step({.time = 0.1 * row, .z = {&z, 1}, .zd = {&zd, 1}});
    if (row == 6) {  // 160° to 192°
      ASSERT_TRUE(s.flag && s.flag->kind == RowFlag::Kind::misfit);
      EXPECT_NEAR(s.flag->after, 178. / 320, 0.02);
    }
    if (row < 3) EXPECT_EQ(s.outcome(), Outcome::converged) << row;
  }
}

/// The same table twice, whose rows are far apart.
TEST(CouplingsByTable, ThatAgreeAreProven) {
  std::vector<double> at, values;
  for (int a = -40; a <= 400; a += 5) {
    at.push_back(a);
    values.push_back(a + 20 * std::sin(3 * a * degree));
  }
  const std::string both =
      coupling_table("first", at, values) + ", " + coupling_table("second", at, values);
  for (const double step : {0.05, 0.3})
    for (const CheckMode mode : {CheckMode::proof, CheckMode::sample}) {
      const CheckedRows r = solve({.couplings = both, .end = 6, .step = step},
                                  "group_automatic_lapack", {.mode = mode});
      EXPECT_EQ(r.summary.outcome(), Outcome::converged)
          << step << ": " << (r.summary.misfit ? r.summary.misfit->amount : 0);
    }
}

/// Scott Russell's crank follows a cam a by a table. It is at 90°, a change point, where a is at
/// 60°: on a knot, in which the third derivative jumps.
TEST(CouplingsByTable, PassChangePointsOnTheirKnots) {
  for (const bool is_even : {false, true})
    for (const double step : {0.25, 0.4}) {
      if (DESMO_SANITIZED && step < 0.4) continue;
      Scene scene = scene_file("scott_russell_on_cam");
      if (is_even) scene.mechanism.couplings[0].table->values[5] = 135;
      const Model m = make_model(scene);
      const TimeGrid grid{0, step, static_cast<int>(6 / step) + 1};
      for (const char* id : {"global_automatic_klu", "group_automatic_lapack"}) {
        SCOPED_TRACE(id + std::to_string(step));
        const CheckedRows r = solve_checked(m, grid, id);
        EXPECT_EQ(r.summary.crossings, 1) << describe(r.summary, m);
        EXPECT_EQ(r.summary.flagged, 1);
        for (const CheckedRow& row : r.rows) {
          const bool is_on_point = row.flag && row.flag->kind == RowFlag::Kind::on_point;
          const double theta = row.values.position[m.coordinate("theta")];
          EXPECT_NEAR(row.values.position[m.coordinate("C.x")], 2 * std::cos(theta),
                      is_on_point ? 1e-7 : 1e-12)
              << row.time;
        }
      }
    }
}

/// A rise to 20° at a = 60°, and back: a wheel that is driven beyond locks there.
TEST(CouplingsByTable, LockWhereTheirTableHasAnExtremum) {
  const std::vector<double> at{0, 20, 40, 60, 80, 100, 120}, up{0, 5, 15, 20, 15, 5, 0},
      steady{0, 5, 10, 15, 20, 25, 30},
      late{0, 5, 10, 15, 19, 21, 21.5};  // would begin to fall after its end
  for (const char* id : {"global_automatic_klu", "group_automatic_lapack"}) {
    // From the drawing at a = 10°.
    Wheel wheel{.couplings = coupling_table("rise", at, up), .driver = "w", .speed = 50};
    Scene scene = wheel.scene();
    const Model m = make_model(scene);
    const CheckedRows locked = solve_checked(m, scene.grid, id);
    EXPECT_FALSE(locked.summary.ok());
    if (locked.summary.status == Status::not_finite) {
      ASSERT_TRUE(locked.summary.table_lock) << id << describe(locked.summary, m);
      EXPECT_EQ(m.entities[locked.summary.table_lock->argument].name, "a");
      EXPECT_NEAR(locked.summary.table_lock->at, 60 * degree, 1e-3);
    }
    for (const auto& values : {steady, late}) {
      wheel.couplings = coupling_table("rise", at, values);
      const CheckedRows ended = solve(wheel, id);
      EXPECT_FALSE(ended.summary.ok());
      EXPECT_FALSE(ended.summary.table_lock) << id;
    }
  }
}

/// Returns w of each row, as a run delivers it.
std::vector<double> wheel_angles(const Wheel& wheel, CheckMode mode) {
  const Scene scene = wheel.scene();
  const Model m = make_model(scene);
  Everything rows(scene.grid.instants);
  const Configuration c = parse_id("group_automatic_lapack/tolerance:1e-6");  // of w, so large
  const auto f = make_formulation(*c.variant, m, c.settings);
  EXPECT_TRUE(run_checked(*f, scene.grid, {}, rows, {.mode = mode}).ok());
  std::vector<double> angles;
  for (const std::vector<double>& q : rows.all) angles.push_back(q.at(m.coordinate("w")));
  return angles;
}

/// Where turns lead back, none of them is made: neither on the way from the drawing nor by a run
/// that is not checked.
TEST(CouplingsByTable, LeaveOutTurnsThatLeadBack) {
  const std::vector<double> at{0, 90, 180, 270, 360}, lift{0, 20, 30, 10, 0},
      index{0, 10, 120, 330, 360};
  for (const bool is_index : {false, true})
    for (const double turns : {1e6, -30000001., 1e8})
      for (const CheckMode mode : {CheckMode::none, CheckMode::proof}) {
        SCOPED_TRACE(std::to_string(is_index) + ", " + std::to_string(turns));
        Wheel wheel{.couplings = is_index ? coupling_table("cam", at, index, "indexing")
                                          : coupling_table("cam", at, lift, "periodic"),
                    .start = 33,
                    .end = 0.2};
        const std::vector<double> near = wheel_angles(wheel, mode);
        wheel.start += 360 * turns;
        const std::vector<double> far = wheel_angles(wheel, mode);
        ASSERT_EQ(near.size(), far.size());
        const double rise = is_index ? 2 * pi * turns : 0;
        for (std::size_t i = 0; i < near.size(); ++i)
          EXPECT_NEAR(far[i], near[i] + rise, 1e-6) << i;
      }
}

/// A table of 350° is not back after a turn.
TEST(CouplingsByTable, LeaveOutNoTurnsThatDoNotLeadBack) {
  const std::vector<double> at{0, 90, 180, 270, 310, 350}, flat{0, 0, 30, 0, 0, 0};
  const Scene scene =
      Wheel{.couplings = coupling_table("cam", at, flat, "periodic"), .start = 360e6 + 33}.scene();
  const Model m = make_model(scene);
  const auto f = make_formulation(find_variant("group_automatic_lapack"), m);
  RowCount rows;
  for (const CheckMode mode : {CheckMode::none, CheckMode::proof}) {
    const CheckedSummary s = run_checked(*f, scene.grid, {}, rows, {.mode = mode});
    EXPECT_EQ(s.status, Status::not_converged);
    EXPECT_EQ(s.start,
              mode == CheckMode::none ? FoundStart::Stage::reached : FoundStart::Stage::drivers);
  }
  EXPECT_TRUE(rows.indices.empty());
  if (DESMO_SANITIZED) return;
  // A tenth of the steps that a continuation has are made, ten times as many are not.
  for (const double turns : {1600., 160000.}) {
    const Scene near =
        Wheel{.couplings = coupling_table("cam", at, flat, "periodic"), .start = 360 * turns + 33}
            .scene();
    const Model at_turns = make_model(near);
    const auto steps = make_formulation(find_variant("group_automatic_lapack"), at_turns);
    EXPECT_EQ(run_checked(*steps, near.grid, {}, rows, {.mode = CheckMode::none}).ok(),
              turns < 1e4);
  }
}

/// 3,000 turns a row are more than a step is tested for; what is not known then is no singularity.
TEST(CouplingsByTable, SayWhereTestsEnded) {
  const std::vector<double> at{0, 90, 180, 270, 310, 350}, flat{0, 0, 30, 0, 0, 0};
  const CheckedRows r =
      solve({.couplings = coupling_table("cam", at, flat, "periodic"), .speed = 3e7, .end = 0.3});
  ASSERT_TRUE(r.summary.first_flag);
  EXPECT_EQ(r.summary.first_flag->kind, RowFlag::Kind::branch);
  EXPECT_TRUE(r.summary.first_flag->out_of_tests);
}

}  // namespace
}  // namespace desmo::tables_test
