// Change points of several drivers.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/branch/departure.h"
#include "formulations/verification/branch/passage.h"
#include "tests/certificate/starts.h"

namespace desmo::passage_test {
namespace {

/// Returns a parallelogram on an arm that turns, too. Two angles are driven.
Model on_arm(const Motion& arm, const Motion& crank) {
  Scene scene = parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "on_arm", "dimension": 2,
      "points": {"O": [0, 0], "D": [2, 0], "B": [0.8, -0.6], "C": [2.8, -0.6]},
      "ground": {"points": ["O"]},
      "bodies": {"arm": {"points": ["O", "D"]}, "crank": {"points": ["O", "B"]},
                 "coupler": {"points": ["B", "C"]}, "rocker": {"points": ["D", "C"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "arm"], "points": ["O"]},
        {"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
        {"type": "revolute", "bodies": ["crank", "coupler"], "points": ["B"]},
        {"type": "revolute", "bodies": ["coupler", "rocker"], "points": ["C"]},
        {"type": "revolute", "bodies": ["arm", "rocker"], "points": ["D"]}],
      "coordinates": {"alpha": {"angle": ["O", "D"]}, "theta": {"angle": ["O", "B"]}},
      "drivers": ["alpha", "theta"]},
    "motion": {"alpha": {"type": "polynomial", "coefficients": [0]},
               "theta": {"type": "polynomial", "coefficients": [0]}},
    "time": {"end": 1, "step": 0.01}})",
                            "on_arm.scene.json", "");
  scene.motions = {arm, crank};
  return make_model(scene);
}

/// Returns how far the coupler of such a parallelogram is from being parallel to the arm.
double skew(const Model& m, std::span<const double> q) {
  const auto at = [&](const char* name) { return m.value(name, q); };
  return std::hypot(at("C.x") - at("B.x") - at("D.x"), at("C.y") - at("B.y") - at("D.y"));
}

TEST(Passage, FollowsSeveralDriversUnlessTheyTurnACorner) {
  const Model both = on_arm(Polynomial{{0, 0.3, 0.2}}, Polynomial{{0, 1, 0.2}});
  StuckPath path(both, -1, 1);
  auto point = passage_of(both, path.present());
  ASSERT_TRUE(point);
  EXPECT_LE(skew(both, positions_on(*point, both, 0)), 1e-12);
  ASSERT_TRUE(path.start_at(point->beyond()));
  ASSERT_EQ(path.go_to(1).end, PathEnd::same);
  EXPECT_LE(skew(both, path.present().values.position), 1e-12);

  // Both drivers rest on the point, and the arm turns on while the crank turns back.
  const Model back = on_arm(Polynomial{{0.343, 0, 0, 1}}, Polynomial{{0.343, 0, -1.3, 1}});
  StuckPath returning(back, -0.7, 0.7);
  const auto turn = passage_of(back, returning.present());
  ASSERT_TRUE(turn);
  ASSERT_TRUE(returning.start_at(turn->beyond()));
  ASSERT_EQ(returning.go_to(0.7).end, PathEnd::same);
  EXPECT_LE(skew(back, returning.present().values.position), 1e-12);

  const Model first = on_arm(Polynomial{{0}}, Polynomial{{0, 1}});
  StuckPath arriving(first, -0.7, 0);
  const std::vector<double> direction{0, 1};
  EXPECT_TRUE(passage_of(first, arriving.present(), direction, 0));
  const Model corner = on_arm(Polynomial{{0, 0.5}}, Polynomial{{0, 1.2}});
  EXPECT_FALSE(passage_of(corner, arriving.present(), direction, 0));
}

/// Drivers that go straight are off their line by rounding alone, which is no corner. At 1000 rad
/// few digits tell a corner of 3e-7 rad: it is a few times as large as rounding may be.
TEST(Passage, TellsACornerFromRounding) {
  for (const double rate : {0.3, 0.7, -0.45}) {
    const Model straight = on_arm(Polynomial{{0, rate}}, Polynomial{{0, 0.9}});
    StuckPath path(straight, -0.6, 0.6);
    EXPECT_TRUE(passage_of(straight, path.present())) << rate;
  }
  const Model first = on_arm(Polynomial{{1000}}, Polynomial{{1000, 1}});
  StuckPath arriving(first, -0.6, 0);
  const std::vector<double> direction{0, 1};
  const Model corner = on_arm(Polynomial{{1000, 4e-7}}, Polynomial{{1000, 1.2}});
  EXPECT_FALSE(passage_of(corner, arriving.present(), direction, 0));
}

/// A fourth of the way off, the angle to the line is a fourth of that of a tangent path, and all of
/// that of a corner.
TEST(Departure, HasACornerWhereItsAngleToTheLineStays) {
  const std::vector<double> direction{0, 1};
  for (const Polynomial& arm : {Polynomial{{0, 0, 0.1}}, Polynomial{{0, 0.1}}}) {
    const Model m = on_arm(arm, Polynomial{{0, 1}});
    std::vector<double> q = m.estimate;
    q[m.coordinate("theta")] = 0;
    const DriverLine line(m, q, direction);
    EXPECT_EQ(Departure(m, line, 0).has_corner(0.1, 0.4), arm.coefficients.size() == 2);
  }
}

}  // namespace
}  // namespace desmo::passage_test
