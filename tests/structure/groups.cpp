// Structural groups of classical mechanisms, found by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "cases/generators/cases.h"
#include "formulations/modelling/groups/structure.h"
#include "formulations/structure/partition.h"
#include "tests/describing.h"
#include "tests/mechanisms.h"
#include "tests/structure/linkages.h"

namespace desmo::groups_test {
namespace {

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

TEST(Groups, OfASliderCrankAreTheCrankAndTheRodWithItsSlider) {
  Linkage l("slider-crank", {{"O", {0, 0, 0}}, {"B", {0.5, 0.8, 0}}, {"P", {3, 0, 0}}});
  l.ground({"O"});
  l.link("crank", {"O", "B"});
  l.link("rod", {"B", "P"});
  l.link("slider", {"P"});
  const int x = l.sketch().ground_vector("x", {1, 0, 0});
  l.sketch().carry(l.body("slider"), {}, {x});
  l.sketch().joint(JointType::prismatic, Sketch::ground, l.body("slider"),
                   {l.point("O"), l.point("P")}, {x});
  l.drive("O", "B");
  expect_groups(model(l.release()), {{{"crank"}, 1, {}}, {{"rod", "slider"}, 0, {0}}});
}

TEST(Groups, OfASliderCrankDrivenAtTheSliderStartThere) {
  Linkage l("slider-crank", {{"O", {0, 0, 0}}, {"B", {0.5, 0.8, 0}}, {"P", {3, 0, 0}}});
  l.ground({"O"});
  l.link("slider", {"P"});  // before the rod, so that it is the one that P's distance drives
  l.link("crank", {"O", "B"});
  l.link("rod", {"B", "P"});
  const int x = l.sketch().ground_vector("x", {1, 0, 0});
  l.sketch().carry(l.body("slider"), {}, {x});
  l.sketch().joint(JointType::prismatic, Sketch::ground, l.body("slider"),
                   {l.point("O"), l.point("P")}, {x});
  l.sketch().along("s", l.point("O"), l.point("P"), x).driven = true;
  expect_groups(model(l.release()), {{{"slider"}, 1, {}}, {{"crank", "rod"}, 0, {0}}});
}

TEST(Groups, OfWattsSixBarDependOnTheDrivenLink) {
  Linkage at_crank = watt();
  at_crank.drive("A0", "A");
  expect_groups(
      model(at_crank.release()),
      {{{"crank"}, 1, {}}, {{"coupler", "rocker"}, 0, {0}}, {{"link5", "link6"}, 0, {1}}});

  Linkage at_rocker = watt();
  at_rocker.drive("B0", "B");
  expect_groups(
      model(at_rocker.release()),
      {{{"rocker"}, 1, {}}, {{"crank", "coupler"}, 0, {0}}, {{"link5", "link6"}, 0, {0, 1}}});

  // Driven at a floating link nothing can be solved before anything else.
  Linkage at_link = watt();
  at_link.drive("C", "E");
  expect_groups(model(at_link.release()),
                {{{"crank", "coupler", "rocker", "link5", "link6"}, 1, {}}});
}

TEST(Groups, OfStephensonsSixBarDependOnTheDrivenLink) {
  Linkage at_crank = stephenson();
  at_crank.drive("A0", "A");
  expect_groups(
      model(at_crank.release()),
      {{{"crank"}, 1, {}}, {{"coupler", "rocker"}, 0, {0}}, {{"link5", "link6"}, 0, {1}}});

  // From the other side: the coupler with its three arms is a triad, of four links.
  Linkage at_link6 = stephenson();
  at_link6.drive("E0", "E");
  expect_groups(model(at_link6.release()),
                {{{"link6"}, 1, {}}, {{"crank", "coupler", "rocker", "link5"}, 0, {0}}});
}

TEST(Groups, OfATriadAreNotSplit) {
  Linkage l("triad", {{"A", {0, 0, 0}},
                      {"B", {4, 0, 0}},
                      {"C", {2, 5, 0}},
                      {"P", {1, 1, 0}},
                      {"Q", {3, 1, 0}},
                      {"R", {2, 2.5, 0}},
                      {"F", {-1, 1, 0}}});
  l.ground({"F", "B", "C"});
  l.link("arm", {"F", "A"});
  l.link("leg a", {"A", "P"});
  l.link("leg b", {"B", "Q"});
  l.link("leg c", {"C", "R"});
  l.link("plate", {"P", "Q", "R"});
  l.drive("F", "A");
  expect_groups(model(l.release()),
                {{{"arm"}, 1, {}}, {{"leg a", "leg b", "leg c", "plate"}, 0, {0}}});
}

TEST(Groups, OfAStewartPlatformDrivenAtItsLegsAreOne) {
  Mechanism d = stewart().release();
  for (Mechanism::Coordinate& c : d.coordinates) c.driven = true;
  std::set<std::string> all;
  for (std::size_t b = 1; b < d.bodies.size(); ++b) all.insert(d.bodies[b].name);
  // Each leg's own direction follows from where the platform holds its head.
  std::vector<Motion> motions(6, still);
  const Model m = model_mechanism(d, motions).model;
  expect_groups(m, {{all, 6, {}}});
}

TEST(Groups, OfAStewartPlatformWhosePoseIsGivenAreThePlatformAndItsLegs) {
  Sketch d = stewart();
  const std::pair<int, int> components[] = {{0, 0}, {0, 1}, {0, 2}, {2, 1}, {2, 2}, {4, 2}};
  for (const auto& [head, axis] : components)  // points are G1, H1, G2, H2, …
    d.component("c" + std::to_string(head) + std::to_string(axis), 2 * head + 1, axis).driven =
        true;
  std::vector<Expected> expected{{{"platform"}, 6, {}}};
  for (int i = 1; i <= 6; ++i) {
    const std::string n = std::to_string(i);
    expected.push_back({{"cylinder" + n, "piston" + n}, 0, {0}});
  }
  expect_groups(model(d.release()), expected);
}

TEST(Groups, StandInSolutionOrderWhateverTheOrderInTheFile) {
  // A chain of dyads, written from its last to its first.
  Linkage l("backwards", {{"A", {0, 0, 0}},
                          {"B", {1, 1.7, 0}},
                          {"D1", {6, 0, 0}},
                          {"C1", {4, 5, 0}},
                          {"D2", {12, 0, 0}},
                          {"C2", {10, 5, 0}}});
  l.link("rocker2", {"D2", "C2"});
  l.link("coupler2", {"C1", "C2"});
  l.link("rocker1", {"D1", "C1"});
  l.link("coupler1", {"B", "C1"});
  l.link("crank", {"A", "B"});
  l.ground({"A", "D1", "D2"});
  l.drive("A", "B");
  const Model m = model(l.release());
  expect_groups(
      m,
      {{{"crank"}, 1, {}}, {{"coupler1", "rocker1"}, 0, {0}}, {{"coupler2", "rocker2"}, 0, {1}}});
  for (const Partition p : {Partition::group, Partition::block})
    EXPECT_NO_THROW(make_partition(m, p));
}

TEST(Groups, OfIndependentMechanismsInOneFileDoNotKnowEachOther) {
  Linkage l("two", {{"A", {0, 0, 0}},
                    {"B", {1, 1.7, 0}},
                    {"D", {6, 0, 0}},
                    {"C", {4, 5, 0}},
                    {"P", {20, 0, 0}},
                    {"Q", {21, 1, 0}}});
  l.ground({"P", "A", "D"});
  l.link("other crank", {"P", "Q"});
  l.link("crank", {"A", "B"});
  l.link("coupler", {"B", "C"});
  l.link("rocker", {"D", "C"});
  l.drive("A", "B");
  l.drive("P", "Q");
  expect_groups(model(l.release()),
                {{{"other crank"}, 1, {}}, {{"crank"}, 1, {}}, {{"coupler", "rocker"}, 0, {1}}});
}

TEST(Groups, OfTheTruckHangOnTheAxle) {
  const Model m = truck_model(2);
  std::vector<Expected> expected;
  for (int a = 0; a < 2; ++a) {
    const std::string p = "axle" + std::to_string(a + 1) + "/";
    const GroupId axle = 5 * a;
    expected.push_back({{p + "2", p + "3", p + "4", p + "5"}, 2, {}});
    for (const auto& [first, second] :
         {std::pair("6", "8"), {"7", "9"}, {"10", "11"}, {"12", "13"}})
      expected.push_back({{p + first, p + second}, 0, {axle}});
  }
  expect_groups(m, expected);
}

TEST(Groups, HaveAsManyRestrictionsAsFreedomsUnlessSomeAreRedundant) {
  const auto structure_of = [](const Mechanism& d) {
    return find_structure(d, find_rigid_bodies(d));
  };
  for (const Mechanism& d : {truck_suspension(2).mechanism, four_bar(7).mechanism})
    for (const StructuralGroup& g : structure_of(d).groups) EXPECT_EQ(g.restrictions, g.freedoms);
  // A spatial four-bar with parallel axes: 3 · 6 freedoms, 4 · 5 + 1 restrictions.
  Sketch d("parallel axes", 3);
  const int z = d.ground_vector("z", {0, 0, 1}), x = d.ground_vector("x", {1, 0, 0}),
            y = d.ground_vector("y", {0, 1, 0});
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int B = d.point("B", {0, 1, 0}), C = d.point("C", {4, 2, 0});
  const int crank = d.body("crank", {A, B}, {z}), coupler = d.body("coupler", {B, C}, {z}),
            rocker = d.body("rocker", {D, C}, {z});
  d.joint(JointType::revolute, Sketch::ground, crank, {A}, {z});
  d.joint(JointType::revolute, crank, coupler, {B}, {z});
  d.joint(JointType::revolute, coupler, rocker, {C}, {z});
  d.joint(JointType::revolute, Sketch::ground, rocker, {D}, {z});
  auto& theta = d.angle("theta", line(A, B), {x});
  theta.towards = {y};
  theta.driven = true;
  const Structure s = structure_of(d.release());
  ASSERT_EQ(s.groups.size(), 1u);
  EXPECT_EQ(s.groups[0].freedoms, 18);
  EXPECT_EQ(s.groups[0].restrictions, 21);
}

}  // namespace
}  // namespace desmo::groups_test
