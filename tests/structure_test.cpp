// Structural groups of classical mechanisms, found by hand, and the irreducible blocks inside them.

#include "formulations/modelling/structure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <set>

#include "cases/cases.h"
#include "formulations/incidence.h"
#include "formulations/partition.h"
#include "tests/describing.h"
#include "tests/mechanisms.h"

namespace desmo {
namespace {

/// A group as a structural diagram shows it: its bodies, (N_m, n_c) and where its arrows come from.
struct Expected {
  std::set<std::string> bodies;
  int drivers;
  std::vector<GroupId> after;
};

void expect_groups(const Mechanism& m, const std::vector<Expected>& expected) {
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

const Motion still = Polynomial{{1}};

Mechanism mechanism(const Description& d) {
  const auto drivers = std::ranges::count(d.coordinates, true, &Description::Coordinate::driven);
  return model(d, std::vector<Motion>(drivers, still)).mechanism;
}

/// Describes planar linkages of pinned links by the names of their points.
class Linkage {
 public:
  explicit Linkage(std::string name, std::map<std::string, Vec> pins) : d_(std::move(name), 2) {
    for (const auto& [pin, at] : pins) point_[pin] = d_.point(pin, at);
  }

  /// Bodies that share a pin are joined there, one to the next in order.
  void link(const std::string& body, const std::vector<std::string>& pins) {
    std::vector<int> points;
    for (const std::string& p : pins) points.push_back(point_.at(p));
    const int b = d_.body(body, points);
    body_[body] = b;
    for (const std::string& p : pins) join(p, b);
  }
  void ground(const std::vector<std::string>& pins) {
    for (const std::string& p : pins) {
      d_.carry(Sketch::ground, {point_.at(p)});
      join(p, Sketch::ground);
    }
  }
  void drive(const std::string& a, const std::string& b) {
    d_.angle("angle of " + a + b, segment(point_.at(a), point_.at(b))).driven = true;
  }
  Sketch& sketch() { return d_; }
  int point(const std::string& pin) const { return point_.at(pin); }
  int body(const std::string& name) const { return body_.at(name); }
  Description take() { return d_.take(); }

 private:
  void join(const std::string& pin, int body) {
    if (const auto it = last_.find(pin); it != last_.end())
      d_.revolute(it->second, body, point_.at(pin));
    last_[pin] = body;
  }

  Sketch d_;
  std::map<std::string, int> point_, body_, last_;
};

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
  expect_groups(mechanism(l.take()), {{{"crank"}, 1, {}}, {{"rod", "slider"}, 0, {0}}});
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
  expect_groups(mechanism(l.take()), {{{"slider"}, 1, {}}, {{"crank", "rod"}, 0, {0}}});
}

/// Watt's six-bar: the four-bar A0 A B B0 carries the dyad of link5 and link6 on coupler and
/// rocker.
Linkage watt() {
  Linkage l("watt", {{"A0", {0, 0, 0}},
                     {"B0", {4, 0, 0}},
                     {"A", {0.6, 0.8, 0}},
                     {"B", {3.6, 2.8, 0}},
                     {"C", {2.5, 4.5, 0}},
                     {"D", {6, 3, 0}},
                     {"E", {5.5, 6, 0}}});
  l.ground({"A0", "B0"});
  l.link("crank", {"A0", "A"});
  l.link("coupler", {"A", "B", "C"});
  l.link("rocker", {"B0", "B", "D"});
  l.link("link5", {"C", "E"});
  l.link("link6", {"D", "E"});
  return l;
}

TEST(Groups, OfWattsSixBarDependOnTheDrivenLink) {
  Linkage at_crank = watt();
  at_crank.drive("A0", "A");
  expect_groups(
      mechanism(at_crank.take()),
      {{{"crank"}, 1, {}}, {{"coupler", "rocker"}, 0, {0}}, {{"link5", "link6"}, 0, {1}}});

  Linkage at_rocker = watt();
  at_rocker.drive("B0", "B");
  expect_groups(
      mechanism(at_rocker.take()),
      {{{"rocker"}, 1, {}}, {{"crank", "coupler"}, 0, {0}}, {{"link5", "link6"}, 0, {0, 1}}});

  // Driven at a floating link nothing can be solved before anything else.
  Linkage at_link = watt();
  at_link.drive("C", "E");
  expect_groups(mechanism(at_link.take()),
                {{{"crank", "coupler", "rocker", "link5", "link6"}, 1, {}}});
}

/// Stephenson's third six-bar: the four-bar A0 A B B0, and on its coupler a dyad to the ground.
Linkage stephenson() {
  Linkage l("stephenson", {{"A0", {0, 0, 0}},
                           {"B0", {4, 0, 0}},
                           {"A", {0.6, 0.8, 0}},
                           {"B", {3.6, 2.8, 0}},
                           {"C", {2.5, 4.5, 0}},
                           {"E", {5.5, 6, 0}},
                           {"E0", {8, 1, 0}}});
  l.ground({"A0", "B0", "E0"});
  l.link("crank", {"A0", "A"});
  l.link("coupler", {"A", "B", "C"});
  l.link("rocker", {"B0", "B"});
  l.link("link5", {"C", "E"});
  l.link("link6", {"E0", "E"});
  return l;
}

TEST(Groups, OfStephensonsSixBarDependOnTheDrivenLink) {
  Linkage at_crank = stephenson();
  at_crank.drive("A0", "A");
  expect_groups(
      mechanism(at_crank.take()),
      {{{"crank"}, 1, {}}, {{"coupler", "rocker"}, 0, {0}}, {{"link5", "link6"}, 0, {1}}});

  // From the other side: the coupler with its three arms is a triad, of four links.
  Linkage at_link6 = stephenson();
  at_link6.drive("E0", "E");
  expect_groups(mechanism(at_link6.take()),
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
  expect_groups(mechanism(l.take()),
                {{{"arm"}, 1, {}}, {{"leg a", "leg b", "leg c", "plate"}, 0, {0}}});
}

/// A Stewart platform; each leg is a cylinder and a piston.
Sketch stewart() {
  Sketch d("stewart", 3);
  std::vector<int> feet, heads, platform_points;
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i + 1);
    feet.push_back(d.ground_point("G" + n, polar(2, i * 1.05 + (i % 2 ? 0.35 : 0))));
    heads.push_back(d.point("H" + n, polar(1, i * 1.05 + (i % 2 ? -0.2 : 0.3)) + Vec{0, 0, 2}));
  }
  const int platform = d.body("platform", heads);
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i + 1);
    const Vec a = polar(2, i * 1.05 + (i % 2 ? 0.35 : 0)),
              b = polar(1, i * 1.05 + (i % 2 ? -0.2 : 0.3)) + Vec{0, 0, 2};
    const Vec axis = unit(b - a), across = unit(cross(axis, {1, 0.1, 0}));
    const int g = d.ground_vector("g" + n, unit(cross(across, {0, 0, 1})));
    const int e = d.vector("e" + n, axis), u = d.vector("u" + n, across);
    const int cylinder = d.body("cylinder" + n, {feet[i]}, {e, u}),
              piston = d.body("piston" + n, {heads[i]}, {e, u});
    d.joint(JointType::universal, Sketch::ground, cylinder, {feet[i]}, {g, u});
    d.joint(JointType::prismatic, cylinder, piston, {feet[i], heads[i]}, {e, u});
    d.joint(JointType::spherical, piston, platform, {heads[i]});
    d.along("s" + n, feet[i], heads[i], e);
  }
  return d;
}

TEST(Groups, OfAStewartPlatformDrivenAtItsLegsAreOne) {
  Description d = stewart().take();
  for (Description::Coordinate& c : d.coordinates) c.driven = true;
  std::set<std::string> all;
  for (std::size_t b = 1; b < d.bodies.size(); ++b) all.insert(d.bodies[b].name);
  // Each leg's own direction follows from where the platform holds its head.
  std::vector<Motion> motions(6, still);
  const Mechanism m = model(d, motions).mechanism;
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
  expect_groups(mechanism(d.take()), expected);
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
  const Mechanism m = mechanism(l.take());
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
  expect_groups(mechanism(l.take()),
                {{{"other crank"}, 1, {}}, {{"crank"}, 1, {}}, {{"coupler", "rocker"}, 0, {1}}});
}

TEST(Groups, OfTheTruckHangOnTheAxle) {
  const Mechanism m = truck_mechanism(2);
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
  const auto structure_of = [](const Description& d) {
    return find_structure(d, find_rigid_bodies(d));
  };
  for (const Description& d : {truck_suspension(2).mechanism, four_bar(7).mechanism})
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
  auto& theta = d.angle("theta", segment(A, B), {x});
  theta.towards = {y};
  theta.driven = true;
  const Structure s = structure_of(d.take());
  ASSERT_EQ(s.groups.size(), 1u);
  EXPECT_EQ(s.groups[0].freedoms, 18);
  EXPECT_EQ(s.groups[0].restrictions, 21);
}

// ---- irreducible blocks ----

/// Blocks are square, cover unknowns and equations once each, and read only what is found before.
void expect_solvable_in_order(const Mechanism& m) {
  std::vector<bool> found(m.state_size(), false);
  for (int i = m.coordinates(); i < m.state_size(); ++i) found[i] = true;
  const std::vector<bool> driven = independent_coordinates(m);
  int unknown_count = 0, equation_count = 0;
  for (int i = 0; i < m.coordinates(); ++i) {
    found[i] = driven[i];
    unknown_count += !driven[i];
  }
  for (const Constraint& c : m.constraints) equation_count += kept_rows(c);
  std::set<std::pair<int, int>> equations;
  int unknowns_covered = 0;
  for (const PartDefinition& b : make_partition(m, Partition::block)) {
    EXPECT_EQ(b.unknowns.size(), b.equations.size());
    for (const int i : b.unknowns) {
      EXPECT_FALSE(found[i]) << "found twice";
      found[i] = true;
      ++unknowns_covered;
    }
    for (const Equation& e : b.equations) {
      EXPECT_TRUE(equations.emplace(e.constraint, e.row).second) << "stated twice";
      EXPECT_FALSE(m.constraints[e.constraint].left_out >> e.row & 1);
      visit_incidence(m, m.constraints[e.constraint], [&](int row, int state) {
        EXPECT_TRUE(row != e.row || found[state])
            << m.constraints[e.constraint].name << " reads ahead";
      });
    }
  }
  EXPECT_EQ(unknowns_covered, unknown_count);
  EXPECT_EQ(static_cast<int>(equations.size()), equation_count);
}

TEST(Blocks, AreSquareCoverEverythingAndReadOnlyWhatIsFoundBefore) {
  expect_solvable_in_order(truck_mechanism(3));
  expect_solvable_in_order(four_bar_mechanism(9));
  Linkage at_crank = watt(), at_link = watt(), triad = stephenson();
  at_crank.drive("A0", "A");
  at_link.drive("C", "E");
  triad.drive("E0", "E");
  for (Linkage* l : {&at_crank, &at_link, &triad}) expect_solvable_in_order(mechanism(l->take()));
  Description d = stewart().take();
  for (Description::Coordinate& c : d.coordinates) c.driven = true;
  expect_solvable_in_order(model(d, std::vector<Motion>(6, still)).mechanism);
}

TEST(Blocks, OfTheTrucksFirstGroupAreOneOfSixteenSixOfThreeAndFiveOfOne) {
  // Sixteen: the axle's WL.x, WL.y, x2, y2, z2 with S, C4.. as far as its arms hold them.
  const Mechanism m = truck_mechanism(1);
  std::map<std::size_t, int> sizes;
  for (const PartDefinition& b : make_partition(m, Partition::block))
    if (b.groups.front() == 1) ++sizes[b.unknowns.size()];
  EXPECT_EQ(sizes, (std::map<std::size_t, int>{{16, 1}, {3, 6}, {1, 5}}));
}

TEST(Blocks, OfAnOrderedChainAreItsSmallestSteps) {
  // Crank: B.x and B.y from θ. Dyad: C and ψ together, from length and angle.
  const Mechanism m = four_bar_mechanism(3);
  std::vector<std::size_t> sizes;
  for (const PartDefinition& b : make_partition(m, Partition::block))
    sizes.push_back(b.unknowns.size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 3, 3, 3}));
}

// ---- growth ----

TEST(Growth, OfTheAnalysisIsNearlyLinear) {
  // Ten times as many dyads take ten times as long; a quadratic step somewhere, a hundred times.
  // The best of several runs each, in this process's own time: a busy machine does not decide.
  const auto seconds = [](int dyads, int runs) {
    double best = 1e9;
    for (int i = 0; i < runs; ++i) {
      const std::clock_t start = std::clock();
      const Mechanism m = four_bar_mechanism(dyads);
      EXPECT_EQ(m.structural_groups(), dyads + 1);
      EXPECT_EQ(make_partition(m, Partition::block).size(), dyads + 2u);
      best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
  };
  const double small = seconds(50, 10), medium = seconds(500, 5), large = seconds(5000, 2);
  EXPECT_LT(medium, 40 * small);
  EXPECT_LT(large, 40 * medium);
}

TEST(Growth, OfEquationsAndOfWhatTheyReadIsLinear) {
  const auto entries = [](int dyads) {
    const Mechanism m = four_bar_mechanism(dyads);
    long count = 0;
    for (const Constraint& c : m.constraints) visit_incidence(m, c, [&](int, int) { ++count; });
    return count;
  };
  const long first = entries(50);
  EXPECT_EQ(entries(100) - first, 10 * (entries(55) - first));
  EXPECT_EQ(entries(5000) - first, 990 * (entries(55) - first));
}

}  // namespace
}  // namespace desmo
