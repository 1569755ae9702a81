// Change points that are passed, on the smooth continuation and on no other.

#include "formulations/verification/branch/passage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <optional>
#include <random>

#include "cases/extremes/rows.h"
#include "cases/io/files.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "tests/certificate/drawn_four_bars.h"
#include "tests/certificate/starts.h"
#include "tests/dead_point.h"

namespace desmo::passage_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int scenes = DESMO_SANITIZED ? 8 : 100;

/// A motion that meets the point at t = 0, from −0.7 sign before it at t = −1.
struct Way {
  const char* name;
  bool passes;
  Motion motion;
};

Way way_of(int i, double point, double sign) {
  const double s = 0.7 * sign;
  const Way ways[] = {
      {"goes on", true, Polynomial{{point, s}}},
      {"rests", true, Polynomial{{point, 0, 0, s}}},
      {"turns back", false, Polynomial{{point, 0, -s}}},
      {"rests and turns back", false, Polynomial{{point, 0, 0, 0, -s}}},
      {"swings across", true, HarmonicSum{point, {{s, pi / 2, 0}}}},
      {"swings back", false, HarmonicSum{point - s / 2, {{s / 2, pi, pi / 2}}}},
  };
  return ways[i % std::size(ways)];
}

TEST(Passage, ContinuesSmoothly) {
  std::mt19937 generator(41);
  int passed = 0;
  for (int i = 0; i < scenes; ++i) {
    const DrawnFourBar scene(generator);
    const Way way = way_of(i, scene.bars.point, scene.sign);
    SCOPED_TRACE(std::to_string(i) + ' ' + way.name);
    const Model m = scene.model(way.motion);
    StuckPath path(m, -1, 1);
    std::optional<PassedPoint> point = passage_of(m, path.present());
    if (!point) continue;
    ++passed;
    EXPECT_EQ(point->after, path.present().time);
    scene.expect_continued(m, *point, way.passes);
  }
  std::cout << passed << " of " << scenes << " passed\n";
  EXPECT_GE(passed, scenes * 95 / 100);
}

/// The way from the drawing leads to the point; the motion goes on from there, or back.
TEST(Passage, BeginsOnThePoint) {
  std::mt19937 generator(42);
  int passed = 0;
  for (int i = 0; i < scenes / 4; ++i) {
    const DrawnFourBar scene(generator);
    const bool passes = i % 2 == 0;
    SCOPED_TRACE(i);
    const double away = passes ? scene.sign : -scene.sign, point = scene.bars.point;
    Polynomial motion{{point, 0.7 * away}};
    if (i % 4 >= 2) motion = {{point, 0, 0.7 * away}};
    const double direction = 0.7 * scene.sign;
    const Model drawn = scene.model(Polynomial{{point, direction}}), m = scene.model(motion);
    StuckPath path(drawn, -1, 0);
    auto passage = passage_of(m, path.present(), std::span(&direction, 1), 0);
    if (!passage) continue;
    ++passed;
    scene.expect_continued(m, *passage, passes);
  }
  EXPECT_GE(passed, scenes / 4 * 95 / 100);
}

TEST(Passage, StopsAtADeadPoint) {
  const double locks = dead_point - pi / 3;
  for (const Motion& motion :
       {Motion(Polynomial{{dead_point, 1}}), Motion(Polynomial{{dead_point, 0, 0, 1}}),
        Motion(Polynomial{{dead_point, 0, -1}})}) {
    Model m = locking_four_bar();
    ASSERT_GT(locks, 0.5);
    m.drivers[0].motion = Polynomial{{pi / 3, 1}};
    StuckPath path(m, 0, locks + 0.1);
    m.drivers[0].motion = motion;
    const double direction = 1;
    EXPECT_FALSE(passage_of(m, path.present(), std::span(&direction, 1), 0));
  }
}

/// A parallelogram of 1 m in a mechanism that is 1,800 km wide and far from the origin. Its crank
/// is driven by the height of its pin. Next to the change point a path begins at √u of the width,
/// and leads 53 times as far, to a dead point: no path that has to lead 80 times as far exists.
TEST(Passage, IsFoundInASmallPartOfALargeMechanism) {
  const Model m = make_model(parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "small_part", "dimension": 2,
      "points": {"O": [1000000, 0], "D": [1000002, 0], "B": [1000000.8, -0.6],
                 "C": [1000002.8, -0.6], "F": [2780000, 0]},
      "ground": {"points": ["O", "D", "F"]},
      "bodies": {"crank": {"points": ["O", "B"], "length": 1},
                 "coupler": {"points": ["B", "C"], "length": 2},
                 "rocker": {"points": ["D", "C"], "length": 1}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
        {"type": "revolute", "bodies": ["crank", "coupler"], "points": ["B"]},
        {"type": "revolute", "bodies": ["coupler", "rocker"], "points": ["C"]},
        {"type": "revolute", "bodies": ["ground", "rocker"], "points": ["D"]}],
      "coordinates": {"h": {"component": "B", "axis": "y"}},
      "drivers": ["h"]},
    "motion": {"h": {"type": "polynomial", "coefficients": [0, 0.6]}},
    "time": {"end": 1, "step": 0.01}})",
                                         "small_part.scene.json", ""));
  EXPECT_NEAR(nominal_size(m), 1.78e6, 1e3);
  StuckPath path(m, -1, 1);
  const auto point = passage_of(m, path.present());
  ASSERT_TRUE(point);
  ASSERT_TRUE(path.start_at(point->beyond()));
  ASSERT_EQ(path.go_to(1).end, PathEnd::same);
  EXPECT_NEAR(m.value("C.y", path.present().values.position), 0.6, 1e-8);
}

/// Most of them lead to the first node; from ten times as far it would be 700 a passage.
TEST(Passage, TakesFewTests) {
  std::mt19937 generator(41);
  constexpr int passages = DESMO_SANITIZED ? 2 : 20;
  int tests = 0;
  for (int i = 0; i < passages; ++i) {
    const DrawnFourBar scene(generator);
    const Model m = scene.model(Polynomial{{scene.bars.point, 0.7 * scene.sign}});
    StuckPath path(m, -1, 1);
    TestBudget budget(BranchPath::max_tests);
    EXPECT_TRUE(pass_change_point(m, path.present(), no_position, budget));
    tests += BranchPath::max_tests - budget.left();
  }
  std::cout << tests / passages << " tests a passage\n";
  EXPECT_LE(tests, 500 * passages);
}

/// Returns a parallelogram whose crank is the rocker of a four-bar, which turns back just where the
/// parallelogram could become an antiparallelogram: there the branches touch. crank: its angle in
/// the drawing and where the motion begins, at t = −1 s.
Model touching_branches(double crank) {
  constexpr double base = 4, rocker = 2.5;
  const double phi = std::acos((16 + 16 - rocker * rocker) / 32);  // crank and coupler in line
  const double ex = (4 * std::cos(phi) - base) / rocker, ey = 4 * std::sin(phi) / rocker;
  DyadChain chain = extremes::one_dyad(1, crank, base, 3, rocker);
  const Mechanism::Vec pin = chain.dyads[0].joint;
  const Mechanism::Vec end{pin[0] + 2 * ex, pin[1] + 2 * ey, 0};
  chain.dyads.push_back(
      {{base + 2 * ex, 2 * ey, 0}, 2, rocker, end, std::atan2(pin[1], pin[0] - base)});
  return make_model(
      extremes::case_of("touching", {chain}, {Polynomial{{crank + 0.7, 0.7}}}, {-1, 0.01, 201})
          .scene);
}

TEST(Passage, IsToldByTheFall) {
  std::mt19937 generator(44);
  for (int i = 0; i < (DESMO_SANITIZED ? 2 : 8); ++i) {
    const DrawnFourBar scene(generator);
    SCOPED_TRACE(i);
    const Model m = scene.model(Polynomial{{scene.bars.point, 0.7 * scene.sign}});
    StuckPath path(m, -1, 1);
    TestBudget budget(BranchPath::max_tests);
    SingularityCrossing crossing(m, path.present(), std::span(&scene.sign, 1), no_position, budget);
    ASSERT_TRUE(crossing.find());
    int level = 0;
    while (crossing.distance(level) > crossing.reach()) ++level;
    const auto at = [&](int l) {
      const std::span<const double> q = crossing.go_to(crossing.distance(l))->values.position;
      return std::vector<double>(q.begin(), q.end());
    };
    const double right = crossing.measure_fall(level, at(level));
    EXPECT_GE(right, 32);  // it is 64, where h is small enough
    EXPECT_LT(right, 320);
    const double other =
        crossing.measure_fall(level, on_other_branch(m, at(level), "crank/B", "dyad1"));
    EXPECT_LT(other, 32);  // it is 2, where h is small enough
    std::cout << right << ' ' << other << '\n';
  }
  // Branches that touch differ in the second derivative only.
  const double direction = 1;
  const Model m = touching_branches(0);
  StuckPath path(m, -1, 1);
  TestBudget budget(BranchPath::max_tests);
  SingularityCrossing crossing(m, path.present(), std::span(&direction, 1), no_position, budget);
  for (const int level : {4, 5, 6}) {
    const double driver = crossing.line().at(crossing.distance(level))[0];
    const auto right = double_solution(touching_branches(driver), std::array{-1.0}).front().q;
    const double other =
        crossing.measure_fall(level, on_other_branch(m, right, "dyad1/C", "dyad2"));
    std::cout << other << '\n';
    EXPECT_GT(other, 3.2);
    EXPECT_LT(other, 32);
  }
}

}  // namespace
}  // namespace desmo::passage_test
