// Mechanisms of the library move alike in any order of their bodies' points and vectors.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>

#include "cases/mechanism/names.h"
#include "tests/modelling/common.h"

namespace desmo::shuffled_library_test {
namespace {

/// Returns the scene with the points and vectors of each body in another order.
Scene with_shuffled_bodies(Scene scene, int seed) {
  std::mt19937 random(seed);
  for (Mechanism::Body& body : scene.mechanism.bodies) {
    std::ranges::shuffle(body.points, random);
    std::ranges::shuffle(body.vectors, random);
  }
  return scene;
}

class ShuffledLibrary : public testing::TestWithParam<std::string_view> {};

TEST_P(ShuffledLibrary, MovesAlike) {
  const Scene scene = library_scene(GetParam());
  std::vector<double> first;
  for (int i = 0; i < std::min(scene.grid.instants, 5); ++i) first.push_back(scene.grid.time(i));
  const Solved expected(make_model(scene), first);
  for (int seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Solved s(make_model(with_shuffled_bodies(scene, seed)), first);
    EXPECT_EQ(s.model().structural_groups(), expected.model().structural_groups());
    for (int k = 0; k < s.instants() && !HasFailure(); ++k)
      for (const Mechanism::Point& p : scene.mechanism.points)
        expect_near(s.position(k, p.name), expected.position(k, p.name), 1e-9, p.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, ShuffledLibrary, testing::ValuesIn(names_of(library())),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace desmo::shuffled_library_test
