// Freedoms that move nothing are named; what they do move is under-constrained.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "formulations/modelling/groups/structure.h"
#include "tests/modelling/common.h"

namespace desmo::idle_freedoms_test {
namespace {

using Idle = std::vector<IdleFreedom>;

Mechanism::Body& coupler_of(Mechanism& mechanism) {
  return *std::ranges::find(mechanism.bodies, "coupler", &Mechanism::Body::name);
}

TEST(IdleFreedom, OfACouplerBetweenTwoSphericalJointsIsItsSpin) {
  const Scene scene = library_scene("rssr");
  EXPECT_EQ(model_mechanism(scene.mechanism, scene.motions).idle,
            (Idle{{"coupler", "the line of 'A' and 'B'"}}));
}

TEST(IdleFreedom, NeitherInThePlaneNorOfWhatCarriesMore) {
  EXPECT_TRUE(
      model_mechanism(driven(four_bar_sketch().release_pinned(), {"theta"}), turning).idle.empty());
  Mechanism mechanism = library_scene("rssr").mechanism;
  coupler_of(mechanism).vectors.push_back(0);  // a vector across its line, which tells the spin
  EXPECT_TRUE(find_idle_freedoms(mechanism, find_rigid_bodies(mechanism)).empty());
}

TEST(IdleFreedom, ThatMovesAPointIsUndetermined) {
  Scene scene = library_scene("rssr");
  Mechanism& mechanism = scene.mechanism;
  mechanism.points.push_back({"E", {0.3, 0.5, 0.9}});
  coupler_of(mechanism).points.push_back(static_cast<int>(mechanism.points.size()) - 1);
  expect_refused(mechanism, scene.motions,
                 {"under-constrained", "1 freedom",
                  "'coupler' is free to spin about the line of "
                  "'A' and 'B'"});
}

}  // namespace
}  // namespace desmo::idle_freedoms_test
