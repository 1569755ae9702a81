// Structural groups of classical mechanisms, found by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "formulations/model/partition.h"
#include "formulations/modelling/groups/structure.h"
#include "tests/modelling/common.h"

namespace desmo::groups_test {
namespace {

Model model(const Mechanism& mechanism) {
  const auto drivers =
      std::ranges::count(mechanism.coordinates, true, &Mechanism::Coordinate::driven);
  return model_mechanism(mechanism, std::vector<Motion>(drivers, still)).model;
}

/// A group as a structural diagram shows it: its bodies, (N_m, n_c) and where its arrows come from.
struct Expected {
  std::set<std::string> bodies;
  int drivers;
  std::vector<GroupId> after;
};

void expect_groups(const Model& m, const std::vector<Expected>& expected) {
  std::vector<GroupId> moving;
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g)
    if (!m.groups[g].constant) moving.push_back(g);
  ASSERT_EQ(moving.size(), expected.size());
  std::map<GroupId, int> drivers;
  for (const Driver& d : m.drivers) ++drivers[m.entities[d.coordinate].group];
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Group& g = m.groups[moving[i]];
    EXPECT_EQ(std::set(g.bodies.begin(), g.bodies.end()), expected[i].bodies) << g.name;
    EXPECT_EQ(g.bodies.size(), expected[i].bodies.size()) << g.name;  // N_m
    EXPECT_EQ(drivers[moving[i]], expected[i].drivers) << g.name;     // n_c
    std::vector<GroupId> after;
    for (const GroupId a : g.after)
      after.push_back(static_cast<GroupId>(std::ranges::find(moving, a) - moving.begin()));
    EXPECT_EQ(after, expected[i].after) << g.name;
  }
}

/// Driven at its crank, its groups are among those of the library.
TEST(Groups, OfASliderCrankBeginWhereItIsDriven) {
  Sketch d("slider-crank", 2);
  const int O = d.ground_point("O", {0, 0, 0}), x = d.ground_vector("x", {1, 0, 0});
  const int B = d.point("B", {0.5, 0.8, 0}), P = d.point("P", {3, 0, 0});
  const int slider = d.body("slider", {P}, {x});  // first: it is the one that s drives
  d.bodies({{"crank", {O, B}}, {"rod", {B, P}}});
  d.joint(JointType::prismatic, Sketch::ground, slider, {O, P}, {x});
  d.along("s", O, P, x).driven = true;
  expect_groups(model(d.release_pinned()), {{{"slider"}, 1, {}}, {{"crank", "rod"}, 0, {0}}});
}

/// Driven as in their files, their groups are among those of the library.
TEST(Groups, OfSixBarsDependOnTheDrivenLink) {
  const auto driven_by = [](const char* six_bar, const char* coordinate) {
    return model(driven(library_scene(six_bar).mechanism, {coordinate}));
  };
  expect_groups(
      driven_by("watt_six_bar", "psi"),
      {{{"rocker"}, 1, {}}, {{"crank", "coupler"}, 0, {0}}, {{"link5", "link6"}, 0, {0, 1}}});
  // Driven at a floating link nothing can be solved before anything else.
  expect_groups(driven_by("watt_six_bar", "phi"),
                {{{"crank", "coupler", "rocker", "link5", "link6"}, 1, {}}});
  expect_groups(
      driven_by("stephenson_six_bar", "alpha"),
      {{{"rocker1"}, 1, {}}, {{"coupler", "rocker2"}, 0, {0}}, {{"crank", "link"}, 0, {1}}});
}

TEST(Groups, OfAStewartPlatformWhosePoseIsGivenAreThePlatformAndItsLegs) {
  Mechanism mechanism = driven(library_scene("stewart").mechanism, {});
  const std::pair<std::string, int> components[] = {{"B1", 0}, {"B1", 1}, {"B1", 2},
                                                    {"B2", 0}, {"B2", 2}, {"B3", 2}};
  for (const auto& [point, axis] : components) {
    Mechanism::Coordinate& c = mechanism.coordinates.emplace_back();
    c.name = point + "xyz"[axis];
    c.type = CoordinateType::component;
    c.point = static_cast<int>(std::ranges::find(mechanism.points, point, &Mechanism::Point::name) -
                               mechanism.points.begin());
    c.axis = axis;
    c.driven = true;
  }
  std::vector<Expected> expected{{{"platform"}, 6, {}}};
  for (int i = 1; i <= 6; ++i) {
    const std::string n = std::to_string(i);
    expected.push_back({{"lower" + n, "upper" + n}, 0, {0}});
  }
  expect_groups(model(mechanism), expected);
}

TEST(Groups, StandInSolutionOrderWhateverTheOrderInTheFile) {
  // A chain of dyads, written from its last to its first.
  Sketch d("backwards", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D1 = d.ground_point("D1", {6, 0, 0}),
            D2 = d.ground_point("D2", {12, 0, 0});
  const int B = d.point("B", {1, 1.7, 0}), C1 = d.point("C1", {4, 5, 0}),
            C2 = d.point("C2", {10, 5, 0});
  d.bodies({{"rocker2", {D2, C2}},
            {"coupler2", {C1, C2}},
            {"rocker1", {D1, C1}},
            {"coupler1", {B, C1}},
            {"crank", {A, B}}});
  d.angle("theta", line(A, B)).driven = true;
  const Model m = model(d.release_pinned());
  expect_groups(
      m,
      {{{"crank"}, 1, {}}, {{"coupler1", "rocker1"}, 0, {0}}, {{"coupler2", "rocker2"}, 0, {1}}});
  for (const Partition p : {Partition::group, Partition::block})
    EXPECT_NO_THROW(make_partition(m, p));
}

TEST(Groups, OfIndependentMechanismsInOneFileDoNotKnowEachOther) {
  Sketch d = four_bar_sketch();
  const int P = d.ground_point("P", {20, 0, 0}), Q = d.point("Q", {21, 1, 0});
  d.body("other crank", {P, Q});
  d.angle("phi", line(P, Q));
  expect_groups(model(driven(d.release_pinned(), {"theta", "phi"})),
                {{{"crank"}, 1, {}}, {{"coupler", "rocker"}, 0, {0}}, {{"other crank"}, 1, {}}});
}

TEST(Groups, HaveAsManyRestrictionsAsFreedomsUnlessSomeAreRedundant) {
  const auto structure_of = [](const Mechanism& mechanism) {
    return find_structure(mechanism, find_rigid_bodies(mechanism));
  };
  for (const Mechanism& mechanism : {truck_suspension(2).mechanism, four_bar(7).mechanism})
    for (const StructuralGroup& g : structure_of(mechanism).groups)
      EXPECT_EQ(g.restrictions, g.freedoms);
  // 3 · 6 freedoms, 4 · 5 + 1 restrictions.
  const Structure s = structure_of(spatial_four_bar());
  ASSERT_EQ(s.groups.size(), 1u);
  EXPECT_EQ(s.groups[0].freedoms, 18);
  EXPECT_EQ(s.groups[0].restrictions, 21);
}

}  // namespace
}  // namespace desmo::groups_test
