// Rows are on the branch of the drawing, or say that it is unknown: whatever the formulation finds,
// however long a step is, and wherever a run begins.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "formulations/verification/reference/reference.h"
#include "formulations/verification/run/checked_motion.h"
#include "formulations/verification/run/live_run.h"
#include "tests/checked/driver_row.h"
#include "tests/checked/rows.h"
#include "tests/dead_point.h"
#include "tests/everything.h"

namespace desmo::branches_test {
namespace {

using std::numbers::pi;

// ---- a formulation that is elsewhere ----

/// Returns an instant of the four-bar of dead_point.h at a crank angle that does not move.
std::vector<double> at_rest(double theta) { return locking_four_bar(Polynomial{{theta}}).estimate; }

std::vector<double> mirrored(const Model& m, std::vector<double> q) {
  return on_other_branch(m, std::move(q), "crank/B", "dyad1");
}

/// Turns the rocker's angle by a whole turn.
std::vector<double> turned(const Model& m, std::vector<double> q) {
  q[m.entities[m.find("dyad1/psi")].first] += 2 * pi;
  return q;
}

/// Null: nothing is handed in, and the motion alone leads to a row.
TEST(Branches, AreThoseOfTheDrawingWhateverIsHandedIn) {
  const Model m = locking_four_bar(Polynomial{{1, 0.1}});
  const std::vector<double> any(m.coordinates());
  for (const auto spoilt : {&mirrored, &turned, decltype(&turned){}})
    for (const int first_spoilt : {0, 1, 5}) {
      CheckedMotion motion(m, {});
      motion.begin(0);
      for (int i = 0; i < 8; ++i) {
        const std::vector<double> right = at_rest(1 + 0.1 * i);
        const bool is_spoilt = i >= first_spoilt;
        const std::vector<double> q = is_spoilt && spoilt ? spoilt(m, right) : right;
        const CheckedInstant* const row = is_spoilt && !spoilt
                                              ? motion.solve({i, 1. * i, any, any, {}})
                                              : &motion.check({i, 1. * i, q, {}, {}});
        ASSERT_TRUE(row) << i;
        EXPECT_FALSE(row->flag) << i;
        EXPECT_EQ(row->is_elsewhere, is_spoilt) << i;
        EXPECT_EQ(row->instant.qd.empty(), !is_spoilt || spoilt) << i;
        EXPECT_TRUE(row->instant.qdd.empty()) << i;
        for (int k = 0; k < m.coordinates(); ++k)
          EXPECT_NEAR(row->instant.q[k], right[k], 1e-14) << i << ", " << k;
      }
      EXPECT_FALSE(motion.solve({8, 20, any, {}, {}}));  // beyond the dead point
    }
}

/// One iteration a step leads them astray.
TEST(Branches, AreRightOrFlaggedWhereNewtonsMethodIsCutShort) {
  for (const auto& [name, id] :
       {std::pair("stewart_iterations1", "group_symbolic_explicit/iterations:1"),
        std::pair("antiparallelogram_iterations1", "group_automatic_eigen/iterations:1")}) {
    const Scene scene = scene_file(name);
    const Model m = make_model(scene);
    const CheckedRows r = solve_checked(m, scene.grid, id);
    EXPECT_NE(r.summary.outcome(), Outcome::converged) << name;
    std::vector<double> times;
    for (const CheckedRow& row : r.rows)
      if (!row.flag) times.push_back(row.time);
    if (times.empty()) continue;
    const Reference reference = make_reference(m, times);
    EXPECT_EQ(expect_within_radii(m, r.rows, reference.instants), std::ssize(times)) << name;
  }
}

// ---- motions that are hard to follow ----

/// A crank of 1 and a rod of 1.05, whose crank swings by whole turns in steps of up to 0.7 rad. The
/// first instant is far from the drawing, at a time of which 1e-13 s are left.
TEST(Branches, AreThoseOfTheDrawingAtLateTimes) {
  const Scene scene = scene_file("short_rod");
  const Model m = make_model(scene);
  const int x = m.coordinate("S.x"), theta = m.coordinate("theta");
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"})
    for (const Level level : all_levels) {
      const CheckedRows r = solve_checked(m, scene.grid, id, level);
      EXPECT_EQ(r.summary.outcome(), Outcome::converged) << id << ": " << describe(r.summary, m);
      for (const CheckedRow& row : r.rows) {
        const std::vector<double>& q = row.values.position;
        const double across = std::sin(q[theta]);
        EXPECT_NEAR(q[x], std::cos(q[theta]) + std::sqrt(1.05 * 1.05 - across * across), 1e-13);
      }
    }
}

/// A crank that turns 0.1 s after the instant at 4 s, 5e-4 rad beyond its dead point.
TEST(Branches, AreUnknownAfterATurnOutOfReach) {
  const Model m = locking_four_bar(Polynomial{{dead_point - 1e-10 - 0.04 - 0.8, 0.41, -0.05}});
  for (const char* id : {"global_automatic_klu", "block_symbolic_explicit",
                         "global_automatic_klu/stride:2", "global_automatic_klu/guess:hermite5"}) {
    const CheckedRows r = solve_checked(m, {0, 1, 9}, id);
    EXPECT_NE(r.summary.outcome(), Outcome::converged) << id;
    for (const CheckedRow& row : r.rows) {
      EXPECT_EQ(row.flag.has_value(), row.time > 4) << id << ", " << row.time;
      if (!row.flag) continue;
      EXPECT_EQ(row.flag->kind, RowFlag::Kind::branch) << id;
      EXPECT_LE(row.flag->after, 4.1) << id;
      EXPECT_GE(row.flag->before, 4) << id;
    }
  }
}

// ---- small parts that large ones carry ----

/// The whole equation of a distance vanishes where its points meet, though no unknown moves fast.
TEST(CarriedParts, MayAllButMeet) {
  std::vector<std::pair<Scene, TimeGrid>> motions{{scene_file("boom"), {0.45, 0.001, 81}}};
  for (const double gap : {1e-6, 1e-4, 1e-2}) {
    Scene scene = scene_file("passing_slider");
    std::ranges::find(scene.mechanism.points, "G", &Mechanism::Point::name)->position[0] = 2 - gap;
    motions.emplace_back(scene, TimeGrid{0.44, 0.001, 25});
  }
  for (const auto& [scene, grid] : motions) {
    const Model m = make_model(scene);
    const Reference reference = make_reference(
        m, times_of(solve_checked(m, grid, "global_automatic_klu").rows, grid.instants));
    for (const char* id :
         {"block_symbolic_inlined", "block_automatic_klu/guess:hermite5", "group_automatic_klu"}) {
      const CheckedRows r = solve_checked(m, grid, id);
      EXPECT_EQ(r.summary.outcome(), Outcome::converged) << id << ": " << describe(r.summary, m);
      EXPECT_EQ(expect_within_radii(m, r.rows, reference.instants), grid.instants) << id;
    }
  }
}

// ---- starts ----

/// Expects that a live row and a run that are not checked deliver what a checked run does.
void expect_as_proven(Formulation& f, const Model& m, const TimeGrid& grid) {
  LiveRun live(f, {.check = CheckMode::none});
  EXPECT_EQ(live.step(DriverRow(m, grid.start)).outcome(), Outcome::converged) << m.name;
  const std::vector<double> row(live.q().begin(), live.q().end());
  Everything proven(grid.instants), plain(grid.instants);
  for (const CheckMode mode : {CheckMode::proof, CheckMode::none}) {
    const CheckedSummary s =
        run_checked(f, grid, {}, mode == CheckMode::none ? plain : proven, {.mode = mode});
    EXPECT_EQ(s.outcome(), Outcome::converged) << m.name << ": " << describe(s, m);
    ASSERT_EQ(s.instants, grid.instants) << m.name;
  }
  for (int k = 0; k < m.coordinates(); ++k) EXPECT_NEAR(row[k], proven.all[0][k], 1e-6) << m.name;
  for (int i = 0; i < grid.instants; ++i)
    for (int k = 0; k < m.coordinates(); ++k)
      EXPECT_NEAR(plain.all[i].at(k), proven.all[i].at(k), 1e-6) << m.name << ", " << i;
}

/// An assembly in one go ends elsewhere or nowhere. Runs that are not checked go in short steps.
TEST(Start, IsLedFromTheDrawingWhereNoAssemblyFindsIt) {
  const Scene scene = library_scene("jansen_leg");
  const Model m = make_model(scene);
  for (const char* id : {"block_automatic_lapack", "block_symbolic_explicit"}) {
    const auto f = make_formulation(find_variant(id), m);
    EXPECT_FALSE(f->assemble(0.5).ok()) << id;
    expect_as_proven(*f, m, {0.5, scene.grid.step, 20});
  }
}

/// The output makes more than half a turn, while the input makes less. Its angle begins within half
/// a turn of the drawing all the same.
TEST(Start, HasAnglesNearestToTheDrawing) {
  const Scene scene = scene_file("drag_link");
  const Model m = make_model(scene);
  const auto f = make_formulation(find_variant("global_automatic_klu"), m);
  expect_as_proven(*f, m, {3.13 / 30, scene.grid.step, 5});
}

}  // namespace
}  // namespace desmo::branches_test
