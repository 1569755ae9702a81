// Change points of mechanisms with several drivers.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/checked/motions.h"

namespace desmo::change_points_test {
namespace {

using std::numbers::pi;

/// A second crank goes on.
TEST(ChangePoints, ArePassedWhereOneDriverTurnsBackBeyondThem) {
  const Scene scene = scene_file("turns_back_beside_a_crank");
  const Model m = make_model(scene);
  const CheckedRows r = solve_checked(m, scene.grid, "group_automatic_lapack");
  EXPECT_EQ(r.summary.flagged, 2) << describe(r.summary, m);
  const int theta = m.coordinate("th"), psi = m.coordinate("ps");
  for (const CheckedRow& row : r.rows)
    if (!row.flag || row.flag->kind != RowFlag::Kind::on_point)
      EXPECT_NEAR(row.values.position[theta], row.values.position[psi], 1e-9);
}

/// The parallelogram's point depends on its own crank. Another crank, with rod and slider, starts
/// elsewhere than drawn, stands or turns, also while the parallelogram rests on the point.
/// tolerance: of rows on a proven branch
void expect_points_of_the_parallelogram(const CheckOptions& options, double tolerance) {
  Scene scene = scene_file("turns_back_beside_a_crank");
  const double drawn = 40 * pi / 180;
  const Motion comes_to_rest = shifted(make_spline(Trapezoid{pi - drawn, 4, 8}), drawn);
  for (const Motion& theta :
       {Motion(Polynomial{{pi, 1}}), Motion(Polynomial{{pi, -1}}), Motion(Polynomial{{pi, 0, 1}}),
        Motion(Polynomial{{pi}}), Motion(Polynomial{{pi - 0.5, 1}}), comes_to_rest})
    for (const Motion& alpha :
         {Motion(Polynomial{{pi / 6}}), Motion(Polynomial{{pi / 6, pi / 2}})}) {
      scene.motions = {theta, alpha};
      const Model m = make_model(scene);
      const CheckedRows r =
          solve_checked(m, {0, 0.125, 13}, "group_automatic_lapack", Level::acceleration, options);
      SCOPED_TRACE(describe(r.summary, m));
      EXPECT_NE(r.summary.outcome(), Outcome::failed);
      EXPECT_EQ(r.summary.crossings, 1);
      for (const CheckedRow& row : r.rows) {
        const bool is_on_point = row.flag && row.flag->kind == RowFlag::Kind::on_point;
        EXPECT_TRUE(!row.flag || is_on_point || row.flag->kind == RowFlag::Kind::crossing)
            << row.time;
        const auto at = [&](const char* name) { return m.value(name, row.values.position); };
        EXPECT_NEAR(std::remainder(at("ps") - at("th"), 2 * pi), 0, is_on_point ? 1e-7 : tolerance);
        const double angle = sample(alpha, row.time).position;
        const double slider =
            0.02 * std::cos(angle) + std::sqrt(0.05 * 0.05 - std::pow(0.02 * std::sin(angle), 2));
        EXPECT_NEAR(at("u"), slider, tolerance / 100) << row.time;
      }
      if (sample(theta, 0).position == pi)
        EXPECT_EQ(m.groups.at(r.summary.first_flag->group).name, "SG-II");
    }
}

TEST(ChangePoints, DependOnTheDriversOfTheirGroupAlone) {
  expect_points_of_the_parallelogram({}, 1e-12);
  expect_points_of_the_parallelogram({.mode = CheckMode::sample, .sample = 4}, 1e-9);
}

}  // namespace
}  // namespace desmo::change_points_test
