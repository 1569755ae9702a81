// Mechanisms of the library move alike in any order of their bodies' points and vectors.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/modelling/common.h"
#include "tests/random.h"

namespace desmo::shuffled_library_test {
namespace {

/// Returns the scene with the points and vectors of each body in another order.
Scene with_shuffled_bodies(Scene scene, Random& random) {
  const auto reorder = [](auto& list, const std::vector<int>& order) {
    const auto before = list;
    for (std::size_t i = 0; i < order.size(); ++i) list[i] = before[order[i]];
  };
  const auto drawn_order = [&](std::size_t n) {
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
  };
  for (Mechanism::Body& body : scene.mechanism.bodies) {
    const auto points = drawn_order(body.points.size()), vectors = drawn_order(body.vectors.size());
    reorder(body.points, points);
    reorder(body.vectors, vectors);
    if (!body.own) continue;
    reorder(body.own->points, points);
    reorder(body.own->vectors, vectors);
  }
  return scene;
}

class ShuffledLibrary : public testing::TestWithParam<std::string> {};

TEST_P(ShuffledLibrary, MovesAlike) {
  const Scene scene = library_scene(GetParam());
  std::vector<double> first;
  for (int i = 0; i < std::min(scene.grid.instants, 5); ++i) first.push_back(scene.grid.time(i));
  const Solved expected(make_model(scene), first);
  for (int seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Solved s(make_model(with_shuffled_bodies(scene, random)), first);
    EXPECT_EQ(s.model().structural_groups(), expected.model().structural_groups());
    for (int k = 0; k < s.instants() && !HasFailure(); ++k)
      for (const Mechanism::Point& p : scene.mechanism.points)
        expect_near(s.position(k, p.name), expected.position(k, p.name), 1e-9, p.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, ShuffledLibrary, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const LibraryMechanism& l : library()) names.emplace_back(l.name);
                           return names;
                         }()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace desmo::shuffled_library_test
