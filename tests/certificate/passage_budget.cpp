// Searches of passages that would not end: they stop where their budget of tests does.

#include <gtest/gtest.h>

#include <iostream>

#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/branch/passage.h"
#include "tests/certificate/starts.h"

namespace desmo::passage_test {
namespace {

/// Returns an arm with two sliders. The x of a point of one and the y of a point of the other are
/// held. As the arm turns, one slider runs off to infinity: its guide becomes vertical. As it turns
/// back, the other one does, whose guide becomes horizontal. Paths creep towards that place in
/// steps of a few roundoff units of 1e8 m.
Model sliders_between_infinities() {
  return make_model(parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "two_sliders", "dimension": 2,
      "points": {"P0": [-1.86, 0.223], "P1": [-1.714, -0.659], "P2": [-3.97, 1.12],
                 "P3": [-0.64, 1.588], "P6": [-0.24, -2.3], "P7": [-3.42, -2.97]},
      "vectors": {"v0": [-0.5144328960579648, 0.8575306382010005],
                  "v2": [0.4440240902949063, -0.8960148476659194]},
      "ground": {"points": ["P0"]},
      "bodies": {"arm": {"points": ["P0", "P1"], "vectors": ["v0", "v2"]},
                 "back": {"points": ["P3", "P2"], "vectors": ["v0"]},
                 "front": {"points": ["P6", "P7"], "vectors": ["v2"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "arm"], "points": ["P0"]},
        {"type": "prismatic", "bodies": ["arm", "back"], "vectors": ["v0"],
         "points": ["P1", "P2"]},
        {"type": "prismatic", "bodies": ["arm", "front"], "vectors": ["v2"],
         "points": ["P1", "P6"]}],
      "coordinates": {"x": {"component": "P6", "axis": "x"},
                      "y": {"component": "P3", "axis": "y"},
                      "angle": {"angle": ["P3", "P2"]}},
      "drivers": ["x", "y", "angle"]},
    "motion": {"x": {"type": "polynomial", "coefficients": [0], "from": "drawing"},
               "y": {"type": "polynomial", "coefficients": [0], "from": "drawing"},
               "angle": {"type": "polynomial", "coefficients": [0, -1.2], "from": "drawing"}},
    "time": {"end": 0.5, "step": 0.0625}})",
                                "two_sliders.scene.json", ""));
}

TEST(PassageBudget, BoundsTheTestsOfAllPaths) {
  const Model m = sliders_between_infinities();
  BranchPath path(m);
  ASSERT_TRUE(start(m, 0, path));
  const FollowedStep step = path.go_to(0.5);
  ASSERT_EQ(step.end, PathEnd::stuck);
  ASSERT_FALSE(step.out_of_tests);
  for (const int tests : {400, BranchPath::max_tests}) {
    TestBudget budget(tests);
    EXPECT_FALSE(pass_change_point(m, path.present(), step.group, budget));
    std::cout << "passage: " << tests - budget.left() << " of " << tests << " tests\n";
    // The only try may take half of the tests. One that did not count them would leave most.
    EXPECT_LE(budget.left(), tests * 6 / 10);
    EXPECT_GE(budget.left(), tests / 2);
  }
}

/// A path takes its tests from the budget, and only half of what is left.
TEST(PassageBudget, IsShared) {
  const Model m = sliders_between_infinities();
  BranchPath path(m);
  ASSERT_TRUE(start(m, 0, path));
  TestBudget budget(800);
  const FollowedStep back = path.go_to(-1.3, budget);
  EXPECT_EQ(back.end, PathEnd::stuck);
  EXPECT_TRUE(back.out_of_tests);
  EXPECT_EQ(back.tests, 400);
  EXPECT_EQ(budget.left(), 400);
  EXPECT_EQ(path.go_to(path.present().time, budget).tests, 0);
  EXPECT_EQ(budget.left(), 399);  // each path counts as at least one
  TestBudget half = budget.half();
  EXPECT_EQ(half.left(), 200);
  half.take(1000);
  EXPECT_EQ(budget.left(), 199);
  budget.take(1000);
  EXPECT_EQ(budget.left(), 0);
}

}  // namespace
}  // namespace desmo::passage_test
