// Change points of mechanisms whose motion has a closed form: passed smoothly, whatever is asked
// for.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/checked/motions.h"
#include "tests/parallelogram.h"
#include "tests/replaced.h"

namespace desmo::passed_points_test {
namespace {

/// The distance of a slider from a point of its line, whose sign changes where they meet, with the
/// crank at 80.4°. So near to that point rounding leaves no digit of the second derivative.
TEST(ChangePoints, ArePassedByADistanceThatChangesItsSign) {
  Scene scene = scene_file("passing_slider");
  std::ranges::find(scene.mechanism.points, "G", &Mechanism::Point::name)->position[0] = 3;
  scene.motions[0] = Polynomial{{0.7, 3}};
  const Model m = make_model(scene);
  const int x = m.coordinate("C.x"), g = m.coordinate("g");
  for (const int steps : {7, 40, 200}) {
    const CheckedRows r =
        solve_checked(m, {0, 1. / steps, steps + 1}, "block_symbolic_inlined", Level::velocity);
    EXPECT_EQ(r.summary.crossings, 1) << describe(r.summary, m);
    EXPECT_EQ(r.summary.flagged, 1) << steps;
    for (const CheckedRow& row : r.rows) {
      EXPECT_NEAR(row.values.position[g], row.values.position[x] - 3, 1e-14) << row.time;
      EXPECT_NEAR(row.values.velocity[g], row.values.velocity[x], 1e-13) << row.time;
    }
  }
}

/// With the transmission angle other equations are tried on the point.
TEST(ChangePoints, ArePassedAtEveryLevel) {
  const std::string theta_alone = R"({"theta": {"angle": ["A", "B"]}})",
                    both = R"({"theta": {"angle": ["A", "B"]},
                              "mu": {"angle": ["B", "C"], "from": ["D", "C"]}})";
  Scene scene = parse_scene(replaced(parallelogram_scene, theta_alone, both), "", {});
  scene.motions[0] = Polynomial{{1, 1}};
  const Model m = make_model(scene);
  const int theta = m.coordinate("theta"), mu = m.coordinate("mu");
  for (const Level level : all_levels) {
    const CheckedRows r = solve_checked(m, {0, 0.1, 61}, "block_symbolic_inlined", level);
    EXPECT_EQ(r.summary.crossings, 2) << describe(r.summary, m);
    EXPECT_EQ(r.summary.flagged, 2) << describe(r.summary, m);
    for (const CheckedRow& row : r.rows)
      EXPECT_NEAR(row.values.position[mu], -row.values.position[theta], 1e-14) << row.time;
  }
}

/// A kite folds, so that its rocker's joint may be anywhere on a circle. What depends on it fails
/// first.
TEST(ChangePoints, AreThoseOfTheGroupThatIsSingular) {
  DyadChain chain = extremes::one_dyad(2, 0.6, 2, 3, 3);
  extremes::add_dyad(chain, 5, 3, 3);
  const TimeGrid grid{0, 0.01, 100};
  const Model m = make_model(extremes::case_of("kite", chain, -1, grid).scene);
  for (const char* id : {"global_automatic_klu", "group_automatic_lapack"}) {
    const CheckedSummary s = solve_checked(m, grid, id).summary;
    ASSERT_TRUE(s.first_flag) << id;
    EXPECT_EQ(m.groups.at(s.first_flag->group).name, "dyad1/SG-I") << id;
  }
}

}  // namespace
}  // namespace desmo::passed_points_test
