// From bodies, joints and drivers to equations: what the modeller must find, judged by equations
// typed from the design pages and by geometry recomputed from solved points.

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>
#include <set>

#include "cases/cases.h"
#include "formulations/modelling/model.h"
#include "tests/describing.h"
#include "tests/mechanisms.h"

namespace desmo {
namespace {

// ---- the equations of the design pages ----

/// An equation as an engineer would compare it: which kind, of what, with which numbers.
struct Stated {
  std::string kind;
  std::vector<std::string> operands;
  std::vector<double> constants;
};

/// Where a kind says the same of its operands in another order, the alphabetical one.
Stated canonical(Stated s) {
  const auto starts = [&](const char* prefix) { return s.kind.starts_with(prefix); };
  auto& o = s.operands;
  if (starts("length") || starts("dot") || starts("distance")) {
    if (o[1] < o[0]) std::swap(o[0], o[1]);
  } else if (starts("projection") && o[2] < o[1]) {
    std::swap(o[1], o[2]);
    s.constants[0] = -s.constants[0];
  } else if (starts("rigid")) {
    std::map<std::string, double> terms;
    for (std::size_t k = 2; k < o.size(); ++k) terms[o[k]] = s.constants[k - 2];
    std::size_t k = 0;
    for (const auto& [name, c] : terms) o[k + 2] = name, s.constants[k++] = c;
  }
  return s;
}

/// The equations of a group, none of them in part.
std::vector<Stated> equations_of(const Mechanism& m, GroupId g) {
  std::vector<Stated> result;
  for (const Constraint& c : m.constraints) {
    if (c.group != g) continue;
    Stated s{{}, {}, c.constants};
    visit_kind(c.kind, [&](auto kind) { s.kind = kind.name; });
    for (const EntityId e : c.operands) s.operands.push_back(m.entities[e].name);
    result.push_back(canonical(std::move(s)));
  }
  return result;
}

void expect_equations(const Mechanism& m, GroupId g, std::vector<Stated> expected) {
  std::vector<Stated> actual = equations_of(m, g);
  for (Stated& s : expected) s = canonical(std::move(s));
  const auto what = [](const Stated& s) { return std::pair(s.kind, s.operands); };
  std::ranges::sort(actual, {}, what);
  std::ranges::sort(expected, {}, what);
  const auto text = [](const Stated& s) {
    std::string t = s.kind;
    for (const std::string& o : s.operands) t += " " + o;
    return t;
  };
  std::vector<std::string> actual_texts, expected_texts;
  for (const Stated& s : actual) actual_texts.push_back(text(s));
  for (const Stated& s : expected) expected_texts.push_back(text(s));
  ASSERT_EQ(actual_texts, expected_texts) << m.groups[g].name;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_EQ(actual[i].constants.size(), expected[i].constants.size()) << actual_texts[i];
    for (std::size_t k = 0; k < actual[i].constants.size(); ++k)
      EXPECT_NEAR(actual[i].constants[k], expected[i].constants[k], 1e-14) << actual_texts[i];
  }
}

void expect_unknowns(const Mechanism& m, GroupId g, std::set<std::string> expected) {
  std::set<std::string> actual;
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (const int i : unknowns(m, g)) actual.insert(m.entities[owner[i]].name);
  EXPECT_EQ(actual, expected) << m.groups[g].name;
}

/// Types the equations of one axle from the design page of the truck suspension.
class AxleOracle {
 public:
  explicit AxleOracle(int axle) : prefix_("axle" + std::to_string(axle) + "/") {}

  std::vector<Stated> axle_and_arms() {
    for (const char* v : {"x2", "y2", "z2"}) unit(v);
    dot("x2", "y2"), dot("x2", "z2"), dot("y2", "z2");
    // offsets from WL = (0, 1, 0), the columns of the table of nominal positions
    state("rigid3_2", {"S", "WL", "y2", "z2"}, {-1, 0.25});
    state("rigid3_2", {"C4", "WL", "y2", "z2"}, {-0.5, -0.15});
    state("rigid3_2", {"C5", "WL", "y2", "z2"}, {-1.5, -0.15});
    state("rigid3_1", {"WR", "WL", "y2"}, {-2});
    length("R", "S", 0.6 * 0.6 + 0.05 * 0.05);
    normal_to_segment("y1", "R", "S");
    unit("n3"), dot("n3", "y1"), normal_to_segment("n3", "R", "S");
    rod("G4", "C4", "u4", "n4", "z2");
    rod("G5", "C5", "u5", "n5", "y2");
    state("component3_z", {"WL", "zL"}, {});
    state("component3_z", {"WR", "zR"}, {});
    return take();
  }

  std::vector<Stated> stabiliser(const std::string& lever, const std::string& link, double y) {
    const std::string A = "A" + lever, B = "B" + lever, e = "e" + lever, n = "n" + lever;
    state("rigid3_2", {A, "WL", "x2", "y2"}, {-0.2, y - 1});
    length(A, B, 0.3 * 0.3 + 0.05 * 0.05);
    normal_to_segment("y2", A, B);
    unit(n), dot(n, "y2"), normal_to_segment(n, A, B);
    state("rigid3_1", {B, A, e}, {std::sqrt(0.3 * 0.3 + 0.05 * 0.05)});
    state("frame_angle", {"x2", "z2", A, B, "phi" + lever}, {});
    const std::string G = "G" + link, u = "u" + link, m = "n" + link;
    length(G, B, 0.05 * 0.05 + 0.4 * 0.4);
    unit(u), dot(u, e), normal_to_segment(u, G, B);
    unit(m), dot(m, u), normal_to_segment(m, G, B);
    return take();
  }

  std::vector<Stated> damper(const std::string& rod, const std::string& tube, double y) {
    const std::string A = "A" + rod, d = "d" + rod, u = "u" + rod;
    state("rigid3_3", {A, "WL", "x2", "y2", "z2"}, {0.15, y - 1, 0.05});
    state("along3", {A, "T" + tube, d, "s" + rod}, {});
    unit(d), unit(u), dot(u, d), dot(u, "x2");
    for (const std::string& n : {"n" + rod, "n" + tube}) unit(n), dot(n, d), dot(n, u);
    return take();
  }

  std::set<std::string> named(std::initializer_list<const char*> names) const {
    std::set<std::string> result;
    for (const std::string name : names) result.insert(prefix_ + name);
    return result;
  }

 private:
  void state(const char* kind, std::vector<std::string> operands, std::vector<double> constants) {
    for (std::string& o : operands)
      if (o != "y1") o.insert(0, prefix_);
    stated_.push_back({kind, std::move(operands), std::move(constants)});
  }
  void unit(const std::string& u) { state("unit3", {u}, {}); }
  void dot(const std::string& u, const std::string& v) { state("dot3", {u, v}, {0}); }
  void length(const std::string& a, const std::string& b, double squared) {
    state("length3", {a, b}, {squared});
  }
  void normal_to_segment(const std::string& u, const std::string& a, const std::string& b) {
    state("projection3", {u, a, b}, {0});
  }
  /// Length, three equations for u, normal to `other` too, and three for n.
  void rod(const char* G, const char* C, const char* u, const char* n, const char* other) {
    length(G, C, 0.8 * 0.8 + 0.05 * 0.05);
    unit(u), dot(u, other), normal_to_segment(u, G, C);
    unit(n), dot(n, u), normal_to_segment(n, G, C);
  }
  std::vector<Stated> take() { return std::exchange(stated_, {}); }

  std::string prefix_;
  std::vector<Stated> stated_;
};

TEST(TruckSuspension, HasExactlyTheEquationsOfItsDesign) {
  for (const int axles : {1, 5}) {
    const Mechanism m = truck_mechanism(axles);
    EXPECT_EQ(m.coordinates(), 111 * axles + 3);
    ASSERT_EQ(m.groups.size(), 1u + 5 * axles);
    ASSERT_EQ(m.drivers.size(), 2u * axles);
    ASSERT_EQ(equations_of(m, 0).size(), 1u);
    const Constraint& y1 = m.constraints.front();
    EXPECT_EQ(equations_of(m, 0)[0].kind, "rigid3_0");
    EXPECT_EQ(m.entities[y1.operands[0]].name, "y1");
    const Entity& held = m.entities[y1.operands[1]];
    ASSERT_TRUE(held.fixed);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(m.fixed_values[held.first + i], i == 1 ? 1 : 0);
    expect_unknowns(m, 0, {"y1"});

    for (int a = 0; a < axles; ++a) {
      AxleOracle o(a + 1);
      const GroupId g = 1 + 5 * a;
      expect_equations(m, g, o.axle_and_arms());
      expect_equations(m, g + 1, o.stabiliser("6", "8", 0.6));
      expect_equations(m, g + 2, o.stabiliser("7", "9", -0.6));
      expect_equations(m, g + 3, o.damper("10", "11", 0.7));
      expect_equations(m, g + 4, o.damper("12", "13", -0.7));
      expect_unknowns(
          m, g,
          o.named({"WL", "S", "C4", "C5", "WR", "x2", "y2", "z2", "n3", "u4", "n4", "u5", "n5"}));
      expect_unknowns(m, g + 1, o.named({"A6", "B6", "e6", "n6", "u8", "n8", "phi6"}));
      expect_unknowns(m, g + 2, o.named({"A7", "B7", "e7", "n7", "u9", "n9", "phi7"}));
      expect_unknowns(m, g + 3, o.named({"A10", "d10", "u10", "n10", "n11", "s10"}));
      expect_unknowns(m, g + 4, o.named({"A12", "d12", "u12", "n12", "n13", "s12"}));
      std::set<std::string> driven;
      for (const int d : {2 * a, 2 * a + 1})
        driven.insert(m.entities[m.drivers[d].coordinate].name);
      EXPECT_EQ(driven, o.named({"zL", "zR"}));
    }
  }
}

TEST(TruckSuspension, LeavesOutOnlyTheUnitLengthOfTheChassisVector) {
  for (const int axles : {1, 5}) {
    const Scene s = truck_suspension(axles);
    const std::vector<LeftOut> left_out = model(s.mechanism, s.motions).left_out;
    ASSERT_EQ(left_out.size(), 1u);
    EXPECT_NE(left_out[0].equation.find("y1 unit"), std::string::npos) << left_out[0].equation;
    EXPECT_EQ(left_out[0].rows, std::vector{0});
    EXPECT_EQ(left_out[0].group, 0);
    EXPECT_EQ(left_out[0].follows_from, std::vector<std::string>{"y1 on the ground"});
    EXPECT_FALSE(left_out[0].redundant);
  }
}

TEST(FourBar, HasExactlyTheEquationsOfItsDesign) {
  for (const int dyads : {1, 185}) {
    const Mechanism m = four_bar_mechanism(dyads);
    EXPECT_EQ(m.coordinates(), 3 + 3 * dyads);
    ASSERT_EQ(m.groups.size(), 1u + dyads);
    ASSERT_EQ(m.drivers.size(), 1u);
    EXPECT_EQ(m.entities[m.drivers[0].coordinate].name, "crank/theta");
    expect_equations(m, 0, {{"planar_angle", {"crank/A", "crank/B", "crank/theta"}, {2}}});
    expect_unknowns(m, 0, {"crank/B"});
    std::string b = "crank/B";
    for (int k = 1; k <= dyads; ++k) {
      const std::string dyad = "dyad" + std::to_string(k) + "/";
      const std::string c = dyad + "C", d = dyad + "D", psi = dyad + "psi";
      expect_equations(m, k, {{"length2", {b, c}, {36}}, {"planar_angle", {d, c, psi}, {6}}});
      expect_unknowns(m, k, {c, psi});
      b = c;
    }
  }
}

TEST(FourBar, LeavesOutTheLengthsThatAnglesDefine) {
  for (const int dyads : {1, 185}) {
    const Scene s = four_bar(dyads);
    const Model modelled = model(s.mechanism, s.motions);
    ASSERT_EQ(modelled.left_out.size(), 1u + dyads);
    for (int g = 0; g <= dyads; ++g) {
      const LeftOut& l = modelled.left_out[g];
      const std::string angle = g == 0 ? "crank/theta" : "dyad" + std::to_string(g) + "/psi";
      EXPECT_EQ(l.group, g);
      EXPECT_EQ(l.rows, std::vector{0});
      EXPECT_NE(l.equation.find("length"), std::string::npos) << l.equation;
      EXPECT_EQ(l.follows_from, std::vector<std::string>{angle + ": definition"});
      EXPECT_FALSE(l.redundant);
    }
  }
}

// ---- redundant but consistent ----

const std::vector<Motion> turning{Polynomial{{1.0, 1}}};

/// Cranks of length 1 on pivots along the x axis, their ends joined by one coupler; the first is
/// driven, nominally at `angle`. Their lengths are equal unless the last one's differs.
Description parallelogram(const std::vector<double>& pivots, double angle = 1,
                          double last_length = 1) {
  Sketch d("parallelogram", 2);
  std::vector<int> feet, ends;
  for (std::size_t i = 0; i < pivots.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    // The ends are where the coupler wants them; another length is that of another pivot.
    const bool last = i + 1 == pivots.size();
    const Vec end = Vec{pivots[i], 0, 0} + polar(1, angle);
    feet.push_back(d.ground_point("D" + n, end - polar(last ? last_length : 1, angle)));
    ends.push_back(d.point("C" + n, end));
  }
  std::vector<int> cranks;
  for (std::size_t i = 0; i < pivots.size(); ++i) {
    cranks.push_back(d.body("crank" + std::to_string(i + 1), {feet[i], ends[i]}));
    d.revolute(Sketch::ground, cranks[i], feet[i]);
  }
  const int coupler = d.body("coupler", ends);
  for (std::size_t i = 0; i < pivots.size(); ++i) d.revolute(cranks[i], coupler, ends[i]);
  d.angle("theta", segment(feet[0], ends[0])).driven = true;
  return d.take();
}

TEST(Redundant, ParallelogramWithThreeCranksIsAcceptedAndReported) {
  const Description d = parallelogram({0, 2, 5});
  const Model modelled = model(d, turning);
  const Mechanism& m = modelled.mechanism;
  EXPECT_EQ(m.structural_groups(), 1);
  EXPECT_EQ(m.groups[0].bodies,
            (std::vector<std::string>{"crank1", "crank2", "crank3", "coupler"}));
  // The first crank's length defines nothing new; one equation of the others is too many.
  ASSERT_EQ(modelled.left_out.size(), 2u);
  std::set<std::string> concerned;
  for (const LeftOut& l : modelled.left_out) {
    EXPECT_TRUE(l.redundant) << l.equation;
    EXPECT_FALSE(l.follows_from.empty()) << l.equation;
    concerned.insert(l.equation);
    for (const std::string& source : l.follows_from) {
      EXPECT_TRUE(std::ranges::any_of(m.constraints, [&](const Constraint& c) {
        return c.name == source;
      })) << source;
      EXPECT_NE(source, l.equation);
    }
  }
  EXPECT_EQ(concerned.size(), 2u);

  const std::vector<double> times = instants(1.5);
  for (const char* id : {"global_automatic_lapack", "global_automatic_eigen", "group_automatic_klu",
                         "block_automatic_eigen"}) {
    const Solved s(m, times, id);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const double theta = 1 + times[k];
      const double pivots[] = {0, 2, 5};
      for (int i = 0; i < 3; ++i) {
        const std::string end = "C" + std::to_string(i + 1);
        const Vec spoke = polar(1, theta), rim = polar(1, theta + std::numbers::pi / 2);
        expect_near(s.position(k, end), Vec{pivots[i], 0, 0} + spoke, 1e-12, end);
        expect_near(s.velocity(k, end), rim, 1e-12, end + " velocity");
        expect_near(s.acceleration(k, end), -1.0 * spoke, 1e-12, end + " acceleration");
      }
    }
  }
}

TEST(Redundant, PlanarFourBarInSpaceWithParallelAxesIsAccepted) {
  Sketch d("bennett_no_more", 3);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0});
  const int z = d.ground_vector("z", {0, 0, 1});
  const int crank = d.body("crank", {A, B}, {z}), coupler = d.body("coupler", {B, C}, {z}),
            rocker = d.body("rocker", {D, C}, {z});
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0});
  d.joint(JointType::revolute, Sketch::ground, crank, {A}, {z});
  d.joint(JointType::revolute, crank, coupler, {B}, {z});
  d.joint(JointType::revolute, coupler, rocker, {C}, {z});
  d.joint(JointType::revolute, Sketch::ground, rocker, {D}, {z});
  auto& theta = d.angle("theta", segment(A, B), {x});
  theta.towards = {y};
  theta.driven = true;
  const Description described = d.take();
  const Model modelled = model(described, turning);
  EXPECT_TRUE(std::ranges::any_of(modelled.left_out, &LeftOut::redundant));
  const std::vector<double> times = instants(1.5);
  for (const char* id :
       {"global_automatic_eigen", "group_automatic_klu", "block_automatic_lapack"}) {
    const Solved s(modelled.mechanism, times, id);
    const auto nominal = [&](const char* name) {
      return std::ranges::find(described.points, name, &Description::Point::name)->position;
    };
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const Vec b = s.position(k, "B"), c = s.position(k, "C");
      expect_near(b, polar(1, 1 + times[k]), 1e-12, "B");
      EXPECT_NEAR(norm(c - b), norm(nominal("C") - nominal("B")), 1e-12);
      EXPECT_NEAR(norm(c - nominal("D")), norm(nominal("C") - nominal("D")), 1e-12);
      EXPECT_NEAR(c[2], 0, 1e-12);
    }
  }
}

// ---- a special position deceives ----

TEST(SpecialPosition, FoldedFourBarKeepsAllItsEquations) {
  // Drawn with all links on one line, a change point of the parallelogram: its coupler and its
  // second crank restrict the same direction there, and there only.
  const Model folded = model(parallelogram({0, 2}, 0), {Polynomial{{0, 1}}});
  const Model open = model(parallelogram({0, 2}, 1), {Polynomial{{0, 1}}});
  for (GroupId g = 0; g < 2; ++g) {
    std::vector<Stated> expected = equations_of(open.mechanism, g);
    expect_equations(folded.mechanism, g, expected);
  }
  EXPECT_EQ(folded.left_out.size(), open.left_out.size());
}

TEST(SpecialPosition, CrankRockerAtItsDeadPointKeepsAllItsEquations) {
  // Crank 1, coupler 3, rocker 3, base 4 with crank and coupler in line: C is at 4 from A, and the
  // rocker, driven, cannot tell the crank's velocity in this position.
  const auto describe_at_dead_point = [](bool driven_by_rocker) {
    Sketch d("dead point", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const double angle = 2 * std::asin(3.0 / 8);  // isosceles: A-C = A-D = 4, C-D = 3
    const int B = d.point("B", polar(1, angle)), C = d.point("C", polar(4, angle));
    const int crank = d.body("crank", {A, B}), coupler = d.body("coupler", {B, C}),
              rocker = d.body("rocker", {D, C});
    d.revolute(Sketch::ground, crank, A);
    d.revolute(crank, coupler, B);
    d.revolute(coupler, rocker, C);
    d.revolute(Sketch::ground, rocker, D);
    d.angle("theta", segment(A, B)).driven = !driven_by_rocker;
    d.angle("psi", segment(D, C)).driven = driven_by_rocker;
    return d.take();
  };
  const double start = 2 * std::asin(3.0 / 8);
  const Mechanism by_crank =
      model(describe_at_dead_point(false), {Polynomial{{start, 1}}}).mechanism;
  expect_equations(by_crank, 0, {{"planar_angle", {"A", "B", "theta"}, {1}}});
  expect_equations(by_crank, 1,
                   {{"length2", {"B", "C"}, {9}}, {"planar_angle", {"D", "C", "psi"}, {3}}});
  const Mechanism by_rocker = model(describe_at_dead_point(true), {Polynomial{{1.0, 1}}}).mechanism;
  expect_equations(by_rocker, 0, {{"planar_angle", {"D", "C", "psi"}, {3}}});
  expect_equations(by_rocker, 1,
                   {{"length2", {"B", "C"}, {9}}, {"planar_angle", {"A", "B", "theta"}, {1}}});
}

/// Crank 1 and rod 3 from the origin, the slider on the x axis, nominally at its turning point.
Description slider_at_turning_point(bool driven_by_slider) {
  Sketch d("slider", 2);
  const int O = d.ground_point("O", {0, 0, 0}), x = d.ground_vector("x", {1, 0, 0});
  const int B = d.point("B", {1, 0, 0}), P = d.point("P", {4, 0, 0});
  const int crank = d.body("crank", {O, B}), rod = d.body("rod", {B, P});
  d.revolute(Sketch::ground, crank, O);
  d.revolute(crank, rod, B);
  d.joint(JointType::revolute_on_slider, Sketch::ground, rod, {O, P}, {x});
  d.angle("theta", segment(O, B)).driven = !driven_by_slider;
  d.along("s", O, P, x).driven = driven_by_slider;
  return d.take();
}

TEST(SpecialPosition, SliderAtItsTurningPointKeepsAllItsEquations) {
  const Mechanism m = model(slider_at_turning_point(false), {Polynomial{{0, 1}}}).mechanism;
  expect_equations(m, 0, {{"planar_angle", {"O", "B", "theta"}, {1}}});
  expect_equations(m, 1, {{"length2", {"B", "P"}, {9}}, {"along2", {"O", "P", "x", "s"}, {}}});
  const std::vector<double> times = instants(1.5);
  const Solved s(m, times);
  for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
    const double t = times[k];
    EXPECT_NEAR(s.scalar(k, "s"), std::cos(t) + std::sqrt(9 - std::sin(t) * std::sin(t)), 1e-12);
  }
  EXPECT_NO_THROW(model(slider_at_turning_point(true), {Polynomial{{3.5, -1}}}));
}

TEST(SpecialPosition, RedundantLinkageDrawnFoldedKeepsEquationsThatDetermineIt) {
  // Two bell cranks joined by two couplers: one coupler too many. Folded, the first coupler
  // restricts the direction that the second crank does and the other one does not; in every other
  // position it is the other one that follows. Chosen for the folded position, the equations would
  // leave `far` undetermined everywhere else.
  const auto bell_cranks = [](double angle) {
    Sketch d("bell cranks", 2);
    int ends[2], ears[2], cranks[2];
    for (const int i : {0, 1}) {
      const std::string n = std::to_string(i + 1);
      const Vec foot{2.0 * i, 0, 0};
      const int D = d.ground_point("D" + n, foot);
      ends[i] = d.point("P" + n, foot + polar(1, angle));
      ears[i] = d.point("Q" + n, foot + polar(0.5, angle + 1));
      cranks[i] = d.body("crank" + n, {D, ends[i], ears[i]});
      d.revolute(Sketch::ground, cranks[i], D);
      if (i == 0) d.angle("theta", segment(D, ends[0])).driven = true;
    }
    const int upper = d.body("coupler", {ends[0], ends[1]});
    const int lower = d.body("second coupler", {ears[0], ears[1]});
    for (const int i : {0, 1}) {
      d.revolute(cranks[i], upper, ends[i]);
      d.revolute(cranks[i], lower, ears[i]);
    }
    d.distance("far", ends[1], ears[0]);
    return d.take();
  };
  const std::vector<double> times = instants(1);
  for (const double angle : {1.0, 0.0}) {
    const Mechanism m = model(bell_cranks(angle), {Polynomial{{1, 1}}}).mechanism;
    std::set<std::string> kinds;
    for (const Stated& s : equations_of(m, 0)) kinds.insert(s.kind);
    EXPECT_TRUE(kinds.contains("distance2")) << "drawn at " << angle;
    if (!kinds.contains("distance2")) continue;
    Mechanism open = m;  // solved away from the fold, where any choice would fail
    open.estimate = model(bell_cranks(1), {Polynomial{{1, 1}}}).mechanism.estimate;
    const Solved s(open, times);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const Vec p = Vec{2, 0, 0} + polar(1, 1 + times[k]);
      expect_near(s.position(k, "P2"), p, 1e-11, "P2");
      EXPECT_NEAR(s.scalar(k, "far"), norm(p - polar(0.5, 2 + times[k])), 1e-11);
    }
  }
}

// ---- contradictions ----

/// A four-bar whose two pivoted links may both be driven.
Sketch four_bar_sketch(std::optional<double> coupler_length = {}) {
  Sketch d("linkage", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0});
  const int crank = d.body("crank", {A, B});
  const int coupler =
      coupler_length ? d.link("coupler", B, C, *coupler_length) : d.body("coupler", {B, C});
  const int rocker = d.body("rocker", {D, C});
  d.revolute(Sketch::ground, crank, A);
  d.revolute(crank, coupler, B);
  d.revolute(coupler, rocker, C);
  d.revolute(Sketch::ground, rocker, D);
  d.angle("theta", segment(A, B));
  d.angle("psi", segment(D, C));
  return d;
}

Description driven(Description d, const std::vector<std::string>& names) {
  for (Description::Coordinate& c : d.coordinates)
    c.driven = std::ranges::find(names, c.name) != names.end();
  return d;
}

const Motion still = Polynomial{{1}};

TEST(Refused, ThirdCrankOfAnotherLength) {
  expect_refused(parallelogram({0, 2, 5}, 1, 1.3), turning,
                 {"over-constrained", "crank3", "coupler", "'theta'"});
}

TEST(Refused, TriangleWithADriver) {
  Sketch d("truss", 2);
  const int A = d.ground_point("A", {0, 0, 0}), B = d.ground_point("B", {2, 0, 0});
  const int C = d.point("C", {1, 1, 0});
  const int left = d.body("left strut", {A, C}), right = d.body("right strut", {B, C});
  d.revolute(Sketch::ground, left, A);
  d.revolute(Sketch::ground, right, B);
  d.revolute(left, right, C);
  d.angle("phi", segment(A, C)).driven = true;
  expect_refused(d.take(), {still}, {"over-constrained", "left strut", "right strut", "'phi'"});
}

TEST(Refused, TooManyDrivers) {
  expect_refused(
      driven(four_bar_sketch().take(), {"theta", "psi"}), {still, still},
      {"over-constrained", "crank", "coupler", "rocker", "'theta'", "'psi'", "too many drivers"});
}

TEST(Refused, MissingDriver) {
  expect_refused(four_bar_sketch().take(), {},
                 {"under-constrained", "'crank'", "'coupler'", "'rocker'", "add a driver",
                  "'theta'", "'psi'"});
}

TEST(Refused, BothDriversOnOneChainWhileAnotherIsFree) {
  Sketch d = four_bar_sketch();
  const int O = d.ground_point("O", {9, 0, 0}), E = d.point("E", {10, 0, 0});
  d.revolute(Sketch::ground, d.body("free arm", {O, E}), O);
  d.angle("alpha", segment(O, E));
  expect_refused(driven(d.take(), {"theta", "psi"}), {still, still},
                 {"under-constrained", "'free arm'", "'alpha'"});
}

TEST(Refused, FiveBarDrivenTwiceAtOneCrank) {
  Sketch d("five-bar", 2);
  const int A = d.ground_point("A", {0, 0, 0}), E = d.ground_point("E", {4, 0, 0});
  const int B = d.point("B", {0, 1, 0}), C = d.point("C", {2, 2, 0}), D = d.point("D", {4, 1, 0});
  const int crank = d.body("crank", {A, B}), left = d.body("left", {B, C}),
            right = d.body("right", {C, D}), second = d.body("second crank", {E, D});
  d.revolute(Sketch::ground, crank, A);
  d.revolute(crank, left, B);
  d.revolute(left, right, C);
  d.revolute(right, second, D);
  d.revolute(Sketch::ground, second, E);
  d.angle("theta", segment(A, B)).driven = true;
  d.component("height", B, 1).driven = true;
  expect_refused(d.take(), {still, still}, {"under-constrained", "'second crank'"});
}

TEST(Refused, DriverThatMeasuresAConstantDistance) {
  // By their number the restrictions suffice; but a crank's length cannot be driven.
  Sketch d = four_bar_sketch();
  d.distance("spoke", 0, 2);  // A-B
  expect_refused(driven(d.take(), {"spoke"}), {still},
                 {"crank", "'spoke'", "do not determine", "drive other coordinates"});
}

TEST(Refused, LinkThatCannotReach) {
  expect_refused(driven(four_bar_sketch(100).take(), {"theta"}), turning,
                 {"cannot be assembled", "coupler", "rocker", "check the dimensions"});
}

TEST(Refused, CoordinateThatMeasuresNothingThatMoves) {
  Sketch d = four_bar_sketch();
  d.distance("base", 0, 1);  // A-D
  const Description measured = driven(d.take(), {"theta"});
  expect_refused(measured, turning, {"'base'", "measures nothing that can move"});
  expect_refused(driven(measured, {"theta", "base"}), {still, still},
                 {"'base'", "measures nothing that can move"});
}

TEST(Refused, BodyThatCarriesNothing) {
  Sketch d = four_bar_sketch();
  d.body("ghost", {});
  expect_refused(driven(d.take(), {"theta"}), turning, {"'ghost'", "carries no point"});
}

TEST(Refused, MechanismWithoutMovingBodies) {
  Sketch d("rock", 2);
  d.ground_point("A", {0, 0, 0});
  expect_refused(d.take(), {}, {"rock", "no body that moves"});
}

TEST(Refused, MotionsThatAreNotOneForEachDriver) {
  expect_refused(driven(four_bar_sketch().take(), {"theta"}), {},
                 {"linkage", "0 motions for 1 driver"});
}

TEST(Refused, TwoLinksOfDifferentLengthBetweenTheSamePoints) {
  Sketch d = four_bar_sketch(3.0);
  const int twin = d.link("twin", 2, 3, 3.5);  // B-C, as the coupler
  d.revolute(1, twin, 2);
  d.revolute(3, twin, 3);
  expect_refused(driven(d.take(), {"theta"}), turning, {"coupler", "twin"});
}

TEST(Refused, SpatialAngleFromASegment) {
  // The definition of an angle in space takes vectors; a segment would be silently misread.
  Sketch d("arm", 3);
  const int O = d.ground_point("O", {0, 0, 0}), X = d.ground_point("X", {1, 0, 0}),
            Z = d.ground_point("Z", {0, 0, 1}), P = d.point("P", {1, 0, 1});
  const int y = d.ground_vector("y", {0, 1, 0});
  d.joint(JointType::revolute, Sketch::ground, d.body("arm", {O, P}, {y}), {O}, {y});
  auto& c = d.angle("phi", segment(O, P), segment(O, X));
  c.towards = segment(O, Z);
  c.driven = true;
  expect_refused(d.take(), turning, {"'phi'"});
}

TEST(Refused, SpatialAngleBetweenDirectionsThatAreNotNormal) {
  // With `towards` at 60 degrees from `from` the definition does not measure an angle.
  Sketch d("arm", 3);
  const int O = d.ground_point("O", {0, 0, 0}), P = d.point("P", {1, 0, 1});
  const int y = d.ground_vector("y", {0, 1, 0}), x = d.ground_vector("x", {1, 0, 0}),
            oblique = d.ground_vector("oblique", {0.5, 0, std::sqrt(0.75)});
  d.joint(JointType::revolute, Sketch::ground, d.body("arm", {O, P}, {y}), {O}, {y});
  auto& c = d.angle("phi", segment(O, P), {x});
  c.towards = {oblique};
  c.driven = true;
  expect_refused(d.take(), turning, {"'phi'"});
}

// ---- fixed joints ----

/// A four-bar whose coupler carries a point P; `split` says how: in one body, or welded ones.
enum class Coupler { whole, two, three };
Description welded_coupler(Coupler split) {
  Sketch d("welded", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            P = d.point("P", {1.5, 3.1, 0}), v = d.vector("v", polar(1, 0.4));
  const int crank = d.body("crank", {A, B}), rocker = d.body("rocker", {D, C});
  int at_crank = 0, at_rocker = 0;
  if (split == Coupler::whole) {
    at_crank = at_rocker = d.body("coupler", {B, C, P}, {v});
  } else if (split == Coupler::two) {
    at_crank = d.body("front", {B, P});
    at_rocker = d.body("back", {C}, {v});
    d.weld(at_rocker, at_crank);
  } else {
    // Welded in a chain whose order is not that of the bodies.
    at_crank = d.body("front", {B});
    at_rocker = d.body("back", {C}, {v});
    const int middle = d.body("middle", {P});
    d.weld(middle, at_rocker);
    d.weld(middle, at_crank);
  }
  d.revolute(Sketch::ground, crank, A);
  d.revolute(crank, at_crank, B);
  d.revolute(at_rocker, rocker, C);
  d.revolute(Sketch::ground, rocker, D);
  d.angle("theta", segment(A, B)).driven = true;
  return d.take();
}

TEST(FixedJoint, WeldedBodiesMoveAsTheirMergedBodyDoes) {
  const std::vector<double> times = instants(2);
  const Description whole = welded_coupler(Coupler::whole);
  const Solved expected(whole, turning, times);
  expect_rigid_bodies(whole, expected, 1e-11);
  for (const Coupler split : {Coupler::two, Coupler::three}) {
    const Solved actual(welded_coupler(split), turning, times);
    EXPECT_EQ(actual.mechanism().coordinates(), expected.mechanism().coordinates());
    EXPECT_EQ(actual.mechanism().structural_groups(), 2);
    for (int k = 0; k < expected.instants() && !HasFailure(); ++k)
      for (const char* name : {"B", "C", "P", "v"}) {
        expect_near(actual.position(k, name), expected.position(k, name), 1e-12, name);
        expect_near(actual.acceleration(k, name), expected.acceleration(k, name), 1e-10, name);
      }
  }
}

TEST(FixedJoint, BodyFixedToTheGroundIsGround) {
  Sketch d("bracketed", 2);
  const int A = d.ground_point("A", {0, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            D = d.point("D", {4, 0, 0}), E = d.point("E", {4, 1, 0});
  const int crank = d.body("crank", {A, B}), coupler = d.body("coupler", {B, C}),
            rocker = d.body("rocker", {D, C});
  const int bracket = d.body("bracket", {E}), foot = d.body("foot", {D});
  d.weld(bracket, foot);  // through another body, and found after it
  d.weld(bracket, Sketch::ground);
  d.revolute(Sketch::ground, crank, A);
  d.revolute(crank, coupler, B);
  d.revolute(coupler, rocker, C);
  d.revolute(foot, rocker, D);
  d.angle("theta", segment(A, B)).driven = true;
  const std::vector<double> times = instants(1);
  const Solved actual(d.take(), turning, times);
  const Solved expected(driven(four_bar_sketch().take(), {"theta"}), turning, times);
  const Mechanism& m = actual.mechanism();
  EXPECT_TRUE(m.entities[m.find("D")].fixed);
  EXPECT_TRUE(m.entities[m.find("E")].fixed);
  for (int k = 0; k < expected.instants() && !HasFailure(); ++k)
    expect_near(actual.position(k, "C"), expected.position(k, "C"), 1e-12, "C");
}

TEST(FixedJoint, GivenLengthIsThatOfItsOwnLinkOnly) {
  // A link of given length welded to a plate: the plate keeps its own dimensions.
  Sketch d("welded link", 2);
  const int O = d.ground_point("O", {0, 0, 0});
  const int P = d.point("P", {3, 0, 0}), A = d.point("A", {0, 1, 0}), B = d.point("B", {1, 1, 0});
  const int plate = d.body("plate", {O, P}), link = d.link("link", A, B, 1);
  d.weld(plate, link);
  d.revolute(Sketch::ground, plate, O);
  d.angle("theta", segment(O, P)).driven = true;
  const std::vector<double> times = instants(1);
  const Solved s(d.take(), {Polynomial{{0, 1}}}, times);
  for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
    expect_near(s.position(k, "P"), polar(3, times[k]), 1e-12, "P");
    EXPECT_NEAR(norm(s.position(k, "B") - s.position(k, "A")), 1, 1e-12);
  }
}

// ---- dimensions given as lengths ----

TEST(Length, IsKeptByALinkThatCarriesAVectorToo) {
  // The vector may be the basis of the link's coordinates; its two points are still that far apart.
  for (const bool with_vector : {false, true}) {
    Sketch d("linkage", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0});
    const int crank = d.body("crank", {A, B}), coupler = d.link("coupler", B, C, 3.1),
              rocker = d.body("rocker", {D, C});
    if (with_vector) d.carry(coupler, {}, {d.vector("v", polar(1, 0.7))});
    d.revolute(Sketch::ground, crank, A);
    d.revolute(crank, coupler, B);
    d.revolute(coupler, rocker, C);
    d.revolute(Sketch::ground, rocker, D);
    d.angle("theta", segment(A, B)).driven = true;
    const std::vector<double> times = instants(1);
    const Solved s(d.take(), turning, times);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k)
      EXPECT_NEAR(norm(s.position(k, "C") - s.position(k, "B")), 3.1, 1e-12)
          << (with_vector ? "with" : "without") << " a vector";
  }
}

// ---- derived points and vectors ----

TEST(Derived, CouplerPointsAndVectorsFollowRigidly) {
  // The same body built on a segment and on a vector; Q is on the line of the segment, B2 where B
  // is.
  for (const bool on_vector : {false, true}) {
    Sketch d("coupler curve", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const Vec b = polar(1, 1), c{3.2, 2.9, 0};
    const int B = d.point("B", b), C = d.point("C", c), P = d.point("P", {1.5, 3.1, 0}),
              Q = d.point("Q", 0.3 * b + 0.7 * c), B2 = d.point("B2", b);
    std::vector<int> vectors{d.vector_along("e", unit(c - b), B, C),
                             d.vector_along("f", unit(Vec{1.5, 3.1, 0} - c), C, P)};
    if (on_vector) vectors.push_back(d.vector("v", polar(1, 0.4)));
    if (on_vector) vectors.push_back(d.vector("w", polar(1, -2)));
    const int crank = d.body("crank", {A, B}), rocker = d.body("rocker", {D, C}),
              coupler = d.body("coupler", {B, C, P, Q, B2}, vectors);
    d.revolute(Sketch::ground, crank, A);
    d.revolute(crank, coupler, B);
    d.revolute(coupler, rocker, C);
    d.revolute(Sketch::ground, rocker, D);
    d.angle("theta", segment(A, B)).driven = true;
    const Description described = d.take();
    const Solved s(described, turning, instants(2));
    expect_rigid_bodies(described, s, 1e-11);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k)
      expect_near(s.position(k, "B2"), s.position(k, "B"), 1e-13, "B2");
  }
}

/// What a spatial body is built on.
struct SpatialBody {
  const char* name;
  std::vector<Vec> points, vectors;
};

TEST(Derived, SpatialBodiesFollowRigidlyWhateverTheyAreBuiltOn) {
  // A free body, driven by six components of three of its points, which come last in one case so
  // that they are derived.
  const Vec o{1, 2, 3}, p{2, 2.2, 3.1}, q{1.3, 3, 2.8},
      in_plane = o + 0.4 * (p - o) + 0.3 * (q - o), on_line = o + 0.25 * (p - o),
      out{1.4, 2.1, 4.2}, farther{0, 1, 2};
  const Vec u = unit({1, 2, -1}), v = unit({0.2, -1, 0.5}), w = unit({-1, 0.3, 2}),
            n = unit(cross(p - o, q - o)), in_plane_vector = unit(p - q);
  const SpatialBody bodies[] = {
      {"three points", {o, p, q, in_plane, on_line}, {}},
      {"three points, and one out of their plane", {o, p, q, in_plane, out, farther}, {}},
      {"three points and vectors", {o, p, q, out}, {n, in_plane_vector, u}},
      {"two points and a vector", {o, p, q, in_plane, out}, {u}},
      {"two points and a vector along them", {o, p, q, out}, {unit(p - o), v}},
      {"a point and two vectors", {o, p, q, out}, {u, v}},
      {"a point and three vectors", {o, on_line, p, q, out, farther}, {u, v, w, n}},
      {"vectors normal to each other", {o, p, q}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {"the driven points last", {farther, out, on_line, o, p, q}, {}},
  };
  for (const SpatialBody& b : bodies) {
    Sketch d(b.name, 3);
    std::vector<int> points, vectors;
    int driven_points[3] = {};
    for (const Vec& at : b.points) {
      points.push_back(d.point("p" + std::to_string(points.size()), at));
      for (int i = 0; i < 3; ++i)
        if (at == (i == 0 ? o : i == 1 ? p : q)) driven_points[i] = points.back();
    }
    for (const Vec& direction : b.vectors)
      vectors.push_back(d.vector("v" + std::to_string(vectors.size()), direction));
    vectors.push_back(
        d.vector_along("along", unit(b.points[2] - b.points[1]), points[1], points[2]));
    d.ground_point("origin", {0, 0, 0});
    d.body("body", points, vectors);
    std::vector<Motion> motions;
    const auto drive = [&](int of, int axis, double from, double rate) {
      d.component("c" + std::to_string(motions.size()), driven_points[of], axis).driven = true;
      motions.push_back(Polynomial{{from, rate}});
    };
    drive(0, 0, o[0], 0.3), drive(0, 1, o[1], -0.2), drive(0, 2, o[2], 0.1);
    drive(1, 1, p[1], 0.25), drive(1, 2, p[2], -0.35), drive(2, 2, q[2], 0.2);
    const Description described = d.take();
    const Solved s(described, motions, instants(0.5));
    expect_rigid_bodies(described, s, 1e-10);
    EXPECT_NEAR(s.position(50, "p0")[0], b.points[0] == o ? o[0] + 0.15 : s.position(50, "p0")[0],
                1e-12);
    if (HasFailure()) FAIL() << b.name;
  }
}

TEST(Derived, PointOfTwoBodiesBeyondTheBasisOfBoth) {
  // The pin P of two ternary links is listed last by each; a third link hangs on it and builds on
  // it. Whoever finds P, its two relations hold the first two links together.
  for (const bool with_hanging_link : {false, true}) {
    Sketch d("shared pin", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const int B = d.point("B", polar(1, 1)), Q = d.point("Q", {1, 2, 0}),
              R = d.point("R", {4, 2, 0}), P = d.point("P", {3.2, 2.9, 0});
    const int crank = d.body("crank", {A, B}), coupler = d.body("coupler", {B, Q, P}),
              rocker = d.body("rocker", {D, R, P});
    d.revolute(Sketch::ground, crank, A);
    d.revolute(crank, coupler, B);
    d.revolute(coupler, rocker, P);
    d.revolute(Sketch::ground, rocker, D);
    if (with_hanging_link) {
      const int E = d.ground_point("E", {7, 0, 0}), F = d.point("F", {6, 3, 0});
      const int hanging = d.body("hanging", {P, F}), last = d.body("last", {E, F});
      d.revolute(rocker, hanging, P);
      d.revolute(hanging, last, F);
      d.revolute(Sketch::ground, last, E);
    }
    d.angle("theta", segment(A, B)).driven = true;
    const Description described = d.take();
    try {
      const Solved s(described, turning, instants(1));
      EXPECT_EQ(s.mechanism().structural_groups(), with_hanging_link ? 3 : 2);
      expect_rigid_bodies(described, s, 1e-11);
    } catch (const std::invalid_argument& e) {
      ADD_FAILURE() << e.what();
    }
  }
}

TEST(Derived, DriverOfAPointThatALaterGroupBuildsOn) {
  // The crank's basis is its mark M; its end B, which the coupler builds on, is driven.
  for (const bool by_angle : {true, false}) {
    Sketch d("marked crank", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const int M = d.point("M", {0.3, 0.1, 0}), B = d.point("B", polar(1, 1)),
              C = d.point("C", {3.2, 2.9, 0});
    const int crank = d.body("crank", {A, M, B}), coupler = d.body("coupler", {B, C}),
              rocker = d.body("rocker", {D, C});
    d.revolute(Sketch::ground, crank, A);
    d.revolute(crank, coupler, B);
    d.revolute(coupler, rocker, C);
    d.revolute(Sketch::ground, rocker, D);
    if (by_angle)
      d.angle("drive", segment(A, B)).driven = true;
    else
      d.component("drive", B, 0).driven = true;
    const Description described = d.take();
    const double start = by_angle ? 1 : std::cos(1);
    try {
      const Solved s(described, {Polynomial{{start, -0.5}}}, instants(0.5));
      EXPECT_EQ(s.mechanism().structural_groups(), 2);
      expect_rigid_bodies(described, s, 1e-11);
    } catch (const std::invalid_argument& e) {
      ADD_FAILURE() << (by_angle ? "angle: " : "component: ") << e.what();
    }
  }
}

TEST(Derived, SliderOnAVectorAlongAnotherBodysSegment) {
  // The guide's vector follows from the guide's points. The block that shares it has not both of
  // them: it still turns with the guide, and its own length is not that of the guide's segment.
  enum class Guide { vector, along, along_with_a_link };
  for (const Guide kind : {Guide::vector, Guide::along, Guide::along_with_a_link}) {
    Sketch d("swinging block", 2);
    const int A = d.ground_point("A", {0, 0, 0}), O = d.ground_point("O", {3, 0, 0});
    const Vec b = polar(1, 1), direction = unit(Vec{3, 0, 0} - b);
    const int B = d.point("B", b), E = d.point("E", b + 5 * direction);
    const int u =
        kind == Guide::vector ? d.vector("u", direction) : d.vector_along("u", direction, B, E);
    const int crank = d.body("crank", {A, B}), guide = d.body("guide", {B, E}, {u});
    const int block = d.body("block", {O}, {u});
    if (kind == Guide::along_with_a_link) {
      const int F = d.point("F", Vec{3, 0, 0} + polar(2, 1.5));
      d.carry(block, {F});
    }
    d.revolute(Sketch::ground, crank, A);
    d.revolute(crank, guide, B);
    d.joint(JointType::prismatic, guide, block, {B, O}, {u});
    d.revolute(Sketch::ground, block, O);
    d.angle("theta", segment(A, B)).driven = true;
    const std::string what = "kind " + std::to_string(static_cast<int>(kind));
    Description described = d.take();
    if (kind == Guide::along_with_a_link) described.bodies[block].length = 2;
    const std::vector<double> times = instants(1);
    try {
      const Model modelled = model(described, turning);
      EXPECT_EQ(modelled.mechanism.structural_groups(), 2) << what;
      EXPECT_FALSE(std::ranges::any_of(modelled.left_out, &LeftOut::redundant)) << what;
      const Solved s(modelled.mechanism, times);
      for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
        const Vec from = polar(1, 1 + times[k]), way = unit(Vec{3, 0, 0} - from);
        expect_near(s.position(k, "u"), way, 1e-11, "u, " + what);
        expect_near(s.position(k, "E"), from + 5 * way, 1e-11, "E, " + what);
      }
    } catch (const std::invalid_argument& e) {
      ADD_FAILURE() << what << ": " << e.what();
    }
  }
}

// ---- what coordinates measure ----

TEST(Coordinates, PlanarOnesMeasureGeometry) {
  Sketch d("measured", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int x = d.ground_vector("x", {1, 0, 0}), g = d.ground_vector("g", polar(1, 2.1));
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            P = d.point("P", {1.5, 3.1, 0}), R = d.point("R", {4.5, 1.4, 0});
  const int v = d.vector("v", polar(1, 0.4)), w = d.vector("w", polar(1, -1.2));
  const int crank = d.body("crank", {A, B}), coupler = d.body("coupler", {B, C, P}, {v}),
            rocker = d.body("rocker", {D, C, R}, {w});
  d.revolute(Sketch::ground, crank, A);
  d.revolute(crank, coupler, B);
  d.revolute(coupler, rocker, C);
  d.revolute(Sketch::ground, rocker, D);
  // A piston on a rod behind the rocker, and a sleeve at the far end of the line.
  const int S = d.point("S", {8, 0, 0}), slider_rod = d.body("slider rod", {R, S});
  d.revolute(rocker, slider_rod, R);
  d.joint(JointType::revolute_on_slider, Sketch::ground, slider_rod, {D, S}, {x});
  d.angle("theta", segment(A, B)).driven = true;
  const Description::Direction AB = segment(A, B), BC = segment(B, C), CB = segment(C, B),
                               BP = segment(B, P), DC = segment(D, C), DR = segment(D, R);
  using Measured = std::pair<Description::Direction, Description::Direction>;
  const std::vector<Measured> angles{
      {BC, {}},
      {{v}, {}},
      {BC, {v}},
      {{v}, BC},
      {{w}, {v}},
      {{w}, {g}},
      {DR, AB},
      {{w}, AB},
      {AB, {w}},
      {{v}, {x}},
      {BC, BP},             // from the same start
      {segment(P, C), BC},  // to the same end
      {BC, AB},             // from where the other ends
      {AB, BC},             // to where the other starts
      {CB, DC},
      {DC, CB},
      {DR, DC},
      {segment(R, D), segment(C, D)},
  };
  for (std::size_t i = 0; i < angles.size(); ++i)
    d.angle("angle" + std::to_string(i), angles[i].first, angles[i].second);
  d.distance("BD", B, D);
  d.distance("PA", P, A);
  d.along("forward", D, S, x);
  d.along("backward", S, D, x);
  d.component("Px", P, 0);
  d.component("Py", P, 1);
  const Description described = d.take();
  const std::vector<double> times = instants(2);
  const Solved s(described, turning, times);
  expect_rigid_bodies(described, s, 1e-10);
  for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
    const auto at = [&](int p) { return s.position(k, described.points[p].name); };
    const auto direction = [&](const Description::Direction& e) -> Vec {
      if (!e.is_given()) return {1, 0, 0};
      if (e.is_segment()) return at(e.to) - at(e.from);
      return s.position(k, described.vectors[e.vector].name);
    };
    expect_near(at(B), polar(1, 1 + times[k]), 1e-12, "B");
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const std::string name = "angle" + std::to_string(i);
      expect_same_angle(s.scalar(k, name),
                        turn(direction(angles[i].second), direction(angles[i].first)), 1e-10, name);
    }
    EXPECT_NEAR(s.scalar(k, "BD"), norm(at(D) - at(B)), 1e-11);
    EXPECT_NEAR(s.scalar(k, "PA"), norm(at(A) - at(P)), 1e-11);
    EXPECT_NEAR(at(S)[1], 0, 1e-12);
    EXPECT_NEAR(s.scalar(k, "forward"), at(S)[0] - 4, 1e-11);
    EXPECT_GT(s.scalar(k, "forward"), 0);
    EXPECT_NEAR(s.scalar(k, "backward"), 4 - at(S)[0], 1e-11);
    EXPECT_LT(s.scalar(k, "backward"), 0);
    EXPECT_NEAR(s.scalar(k, "Px"), at(P)[0], 1e-13);
    EXPECT_NEAR(s.scalar(k, "Py"), at(P)[1], 1e-13);
  }
}

TEST(Coordinates, SpatialOnesMeasureGeometry) {
  // An arm that turns about y, and a sleeve that slides and turns on a shaft fixed to it.
  for (const double start : {0.3, 2.6, -0.8}) {
    Sketch d("arm and sleeve", 3);
    const int O = d.ground_point("O", {0.5, 1, 2}), F = d.ground_point("F", {-2, 0, 0});
    const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
              z = d.ground_vector("z", {0, 0, 1});
    const Vec o{0.5, 1, 2}, radial{std::cos(start), 0, std::sin(start)};
    const int P = d.point("P", o + 2 * radial), Q = d.point("Q", o + 2 * radial + Vec{0, 0.5, 0});
    const int r = d.vector("r", radial), n = d.vector("n", cross({0, 1, 0}, radial));
    const int S = d.point("S", o + 3 * radial), T = d.point("T", o + 3 * radial + Vec{0, 1, 0});
    const int b = d.vector("b", {0, 1, 0}), c = d.vector("c", cross({0, 1, 0}, radial));
    const int arm = d.body("arm", {O, P, Q}, {y, r, n}),
              sleeve = d.body("sleeve", {S, T}, {r, b, c});
    d.joint(JointType::revolute, Sketch::ground, arm, {O}, {y});
    d.joint(JointType::cylindrical, arm, sleeve, {P, S}, {r});
    const auto angle = [&](const char* name, const Description::Direction& of, int from,
                           int towards, bool opposite) -> Description::Coordinate& {
      auto& a = d.angle(name, of, {from});
      a.towards = {towards};
      a.opposite = opposite;
      return a;
    };
    angle("phi", segment(O, P), x, z, false).driven = true;
    angle("spin", {b}, y, n, false).driven = true;
    angle("phi vector", {r}, x, z, false);
    angle("phi opposite", segment(O, P), x, z, true);
    angle("phi vector opposite", {r}, x, z, true);
    d.component("sleeve x", S, 0);
    d.component("sleeve y", S, 1);
    d.component("sleeve z", S, 2);
    d.distance("reach", F, T);
    d.along("slide", P, S, r).driven = true;
    d.along("back", S, O, r);
    const Description described = d.take();
    const std::vector<double> times = instants(1);
    const Solved s(described, {Polynomial{{start, 0.7}}, Polynomial{{0, 1}}, Polynomial{{1, 0.5}}},
                   times);
    expect_rigid_bodies(described, s, 1e-10);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const double t = times[k], phi = start + 0.7 * t;
      const Vec now{std::cos(phi), 0, std::sin(phi)}, sleeve_at = o + (3 + 0.5 * t) * now;
      expect_near(s.position(k, "r"), now, 1e-11, "r");
      expect_near(s.position(k, "S"), sleeve_at, 1e-11, "S");
      expect_same_angle(s.scalar(k, "phi vector"), phi, 1e-11, "phi vector");
      for (const char* name : {"phi opposite", "phi vector opposite"})
        expect_same_angle(s.scalar(k, name), std::atan2(now[2], -now[0]), 1e-11, name);
      const Vec up = s.position(k, "b");
      EXPECT_NEAR(up[1], std::cos(t), 1e-11);
      EXPECT_NEAR(dot(up, cross({0, 1, 0}, now)), std::sin(t), 1e-11);
      EXPECT_NEAR(s.scalar(k, "sleeve x"), sleeve_at[0], 1e-11);
      EXPECT_NEAR(s.scalar(k, "sleeve y"), sleeve_at[1], 1e-11);
      EXPECT_NEAR(s.scalar(k, "sleeve z"), sleeve_at[2], 1e-11);
      EXPECT_NEAR(s.scalar(k, "reach"), norm(s.position(k, "T") - Vec{-2, 0, 0}), 1e-11);
      EXPECT_NEAR(s.scalar(k, "back"), -(3 + 0.5 * t), 1e-11);
    }
  }
}

TEST(Coordinates, SpatialSlidingJointsHaveADistanceUnlessOneIsDeclared) {
  for (const bool declared : {false, true}) {
    Sketch d("slide", 3);
    const int O = d.ground_point("O", {0, 0, 0}), P = d.point("P", {2, 0, 0});
    const int x = d.ground_vector("x", {1, 0, 0}), z = d.ground_vector("z", {0, 0, 1});
    const int block = d.body("block", {P}, {x, z});
    d.joint(JointType::prismatic, Sketch::ground, block, {O, P}, {x, z});
    if (declared) d.along("s", P, O, x);  // either way round
    d.component("at", P, 0).driven = true;
    const Description described = d.take();
    const Solved s(described, {Polynomial{{2, 1}}}, instants(0.5));
    const Mechanism& m = s.mechanism();
    const std::string automatic = described.joints.front().name + "/distance";
    const bool present =
        std::ranges::find(m.entities, automatic, &Entity::name) != m.entities.end();
    ASSERT_EQ(present, !declared);
    EXPECT_NEAR(s.scalar(50, declared ? "s" : automatic), declared ? -2.5 : 2.5, 1e-12);
  }
}

TEST(Coordinates, AnyOfThemCanDrive) {
  // The same four-bar in the same motion, driven by what another coordinate of it measured.
  const auto described = [](const std::string& driver) {
    Sketch d = four_bar_sketch();
    d.distance("BD", 2, 1);
    d.angle("mu", segment(2, 3), segment(0, 2));     // B-C from A-B
    d.angle("gamma", segment(3, 2), segment(3, 1));  // C-B from C-D
    d.component("Cx", 3, 0);
    d.component("By", 2, 1);
    return driven(d.take(), {driver});
  };
  const double t = 0.2;
  const Solved expected(described("theta"), turning, std::vector{t});
  for (const char* driver : {"psi", "BD", "mu", "gamma", "Cx", "By"}) {
    const double value = expected.scalar(0, driver);
    Solved actual(described(driver), {Polynomial{{value}}}, std::vector{0.0});
    for (const char* name : {"B", "C"})
      expect_near(actual.position(0, name), expected.position(0, name), 1e-10,
                  name + std::string(" driven by ") + driver);
  }
}

// ---- invariance ----

/// The description with its lists in another order; the ground stays first, and the relative order
/// of driven coordinates, which the motions follow.
Description permuted(const Description& d, unsigned seed) {
  std::mt19937 random(seed);
  const auto shuffled = [&](std::size_t n, std::size_t keep) {
    std::vector<int> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<int>(i);
    std::shuffle(order.begin() + keep, order.end(), random);
    return order;
  };
  const auto moved = [](const std::vector<int>& order) {  // where each went
    std::vector<int> to(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) to[order[i]] = static_cast<int>(i);
    return to;
  };
  const auto take = [](const auto& list, const std::vector<int>& order) {
    auto result = list;
    for (std::size_t i = 0; i < order.size(); ++i) result[i] = list[order[i]];
    return result;
  };
  const auto points = shuffled(d.points.size(), 0), vectors = shuffled(d.vectors.size(), 0),
             bodies = shuffled(d.bodies.size(), 1), joints = shuffled(d.joints.size(), 0);
  const auto new_point = moved(points), new_vector = moved(vectors), new_body = moved(bodies);
  const auto point = [&](int& p) { p = p < 0 ? p : new_point[p]; };
  const auto vector = [&](int& v) { v = v < 0 ? v : new_vector[v]; };
  Description r = d;
  r.points = take(d.points, points);
  r.vectors = take(d.vectors, vectors);
  r.bodies = take(d.bodies, bodies);
  r.joints = take(d.joints, joints);
  std::ranges::stable_partition(r.coordinates, [](const auto& c) { return c.driven; });
  for (Description::Vector& v : r.vectors)
    if (v.along) point((*v.along)[0]), point((*v.along)[1]);
  for (Description::Body& b : r.bodies) {
    std::ranges::for_each(b.points, point);
    std::ranges::for_each(b.vectors, vector);
  }
  for (Description::Joint& j : r.joints) {
    for (int& b : j.bodies) b = new_body[b];
    std::ranges::for_each(j.points, point);
    std::ranges::for_each(j.vectors, vector);
  }
  for (Description::Coordinate& c : r.coordinates) {
    for (Description::Direction* e : {&c.of, &c.from, &c.towards})
      point(e->from), point(e->to), vector(e->vector);
    vector(c.vector);
    point(c.point);
  }
  return r;
}

/// A mechanism to be solved in other guises, and how its drivers move.
struct Sample {
  Description description;
  std::vector<Motion> motions;
  bool translates = true;
};

/// Planar: a four-bar with a coupler point, driven by a relative angle, and a slider that hangs on
/// it.
Sample planar_sample() {
  Sketch d("planar sample", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int x = d.ground_vector("x", {1, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            P = d.point("P", {1.5, 3.1, 0}), S = d.point("S", {7, 0.5, 0});
  const int crank = d.body("crank", {A, B}), coupler = d.body("coupler", {B, C, P}),
            rocker = d.body("rocker", {D, C}), rod = d.body("rod", {C, S}),
            piston = d.body("piston", {S}, {x});
  d.revolute(Sketch::ground, crank, A);
  d.revolute(crank, coupler, B);
  d.revolute(coupler, rocker, C);
  d.revolute(Sketch::ground, rocker, D);
  d.revolute(rocker, rod, C);
  d.revolute(rod, piston, S);
  d.joint(JointType::prismatic, Sketch::ground, piston, {D, S}, {x});
  d.angle("theta", segment(A, B), {x}).driven = true;
  d.angle("mu", segment(C, B), segment(C, D));
  d.distance("AP", A, P);
  return {d.take(), turning};
}

/// Spatial: a crank about z and a rocker about x, joined by a rod with spherical ends (RSSR).
Sample spatial_sample() {
  Sketch d("spatial sample", 3);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 3, 0.5});
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1}), axis = d.ground_vector("axis", {1, 0, 0});
  const int B = d.point("B", polar(1, 0.5)), C = d.point("C", {4, 3, 3});
  const int W = d.point("W", {4.5, 3.5, 2});
  const int crank = d.body("crank", {A, B}, {z}), rod = d.body("rod", {B, C}),
            rocker = d.body("rocker", {D, C, W}, {axis});
  d.joint(JointType::revolute, Sketch::ground, crank, {A}, {z});
  d.joint(JointType::spherical, crank, rod, {B});
  d.joint(JointType::spherical, rod, rocker, {C});
  d.joint(JointType::revolute, Sketch::ground, rocker, {D}, {axis});
  auto& theta = d.angle("theta", segment(A, B), {x});
  theta.towards = {y};
  theta.driven = true;
  d.distance("AW", A, W);
  return {d.take(), {Polynomial{{0.5, 1}}}};
}

Sample truck_sample() {
  Scene s = truck_suspension(1);
  return {s.mechanism, s.motions, false};
}

/// The rotation about z, then (space) about x.
Vec rotated(const Vec& p, int dimension) {
  const Vec q{0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2]};
  if (dimension == 2) return q;
  const double c = std::cos(0.9), s = std::sin(0.9);
  return {q[0], c * q[1] - s * q[2], s * q[1] + c * q[2]};
}

struct Guise : testing::TestWithParam<int> {
  Sample sample = GetParam() == 0   ? planar_sample()
                  : GetParam() == 1 ? spatial_sample()
                                    : truck_sample();
  std::vector<double> times = instants(0.5);

  /// Structure is the same, and every point and length is the image of the original's.
  template <class Image>
  void expect_image(const Description& other, const std::vector<Motion>& motions, double scale,
                    Image&& image) {
    const Mechanism original = model(sample.description, sample.motions).mechanism;
    const Mechanism changed = model(other, motions).mechanism;
    EXPECT_EQ(changed.coordinates(), original.coordinates());
    EXPECT_EQ(changed.structural_groups(), original.structural_groups());
    int rows[2] = {0, 0};
    for (const Constraint& c : original.constraints) rows[0] += kept_rows(c);
    for (const Constraint& c : changed.constraints) rows[1] += kept_rows(c);
    EXPECT_EQ(rows[1], rows[0]);

    const Solved a(original, times),
        b(changed, times, "global_automatic_eigen", 1e-13 * std::max(1.0, scale * scale));
    for (int k = 0; k < a.instants() && !HasFailure(); k += 10) {
      for (const Description::Point& p : sample.description.points)
        expect_near(1 / scale * b.position(k, p.name), image(a.position(k, p.name)), 1e-8, p.name);
      for (const Description::Coordinate& c : sample.description.coordinates) {
        if (c.type == CoordinateType::angle)
          expect_same_angle(b.scalar(k, c.name), a.scalar(k, c.name), 1e-8, c.name);
        else
          EXPECT_NEAR(b.scalar(k, c.name) / scale, a.scalar(k, c.name), 1e-8) << c.name;
      }
    }
  }
};

TEST_P(Guise, NamesOfBodiesDoNotMatter) {
  Description d = sample.description;
  for (std::size_t b = 1; b < d.bodies.size(); ++b)
    d.bodies[b].name = "body " + std::to_string(d.bodies.size() - b);
  for (std::size_t j = 0; j < d.joints.size(); ++j) d.joints[j].name = "j" + std::to_string(j);
  expect_image(d, sample.motions, 1, std::identity{});
}

TEST_P(Guise, OrderDoesNotMatter) {
  for (unsigned seed = 1; seed <= 6; ++seed)
    expect_image(permuted(sample.description, seed), sample.motions, 1, std::identity{});
}

TEST_P(Guise, OrderWithinBodiesAndJointsDoesNotMatter) {
  // What a body is built on changes, so that the equations do; their number does not.
  Description d = sample.description;
  for (Description::Body& b : d.bodies) std::ranges::reverse(b.points);
  for (Description::Joint& j : d.joints) {
    using enum Description::JointType;
    std::swap(j.bodies[0], j.bodies[1]);
    if (j.type == prismatic || j.type == cylindrical) std::swap(j.points[0], j.points[1]);
    if (j.type == universal) std::swap(j.vectors[0], j.vectors[1]);
  }
  expect_image(d, sample.motions, 1, std::identity{});
}

TEST_P(Guise, TheUnitOfLengthDoesNotMatter) {
  for (const double scale : {1e3, 1e-3}) {
    Description d = sample.description;
    for (Description::Point& p : d.points) p.position = scale * p.position;
    std::vector<Motion> motions = sample.motions;
    std::size_t motion = 0;
    for (const Description::Coordinate& c : d.coordinates) {
      if (!c.driven) continue;
      Motion& z = motions[motion++];
      if (c.type == CoordinateType::angle) continue;
      auto& harmonic = std::get<HarmonicSum>(z);
      harmonic.mean *= scale;
      for (HarmonicSum::Term& term : harmonic.terms) term.amplitude *= scale;
    }
    expect_image(d, motions, scale, std::identity{});
  }
}

TEST_P(Guise, WhereItStandsDoesNotMatter) {
  if (!sample.translates) GTEST_SKIP() << "its heights are measured from the origin";
  const auto image = [&](const Vec& p) {
    return rotated(p, sample.description.dimension) + Vec{3, -2, 0};
  };
  Description d = sample.description;
  for (Description::Point& p : d.points) p.position = image(p.position);
  for (Description::Vector& v : d.vectors) v.direction = rotated(v.direction, d.dimension);
  expect_image(d, sample.motions, 1, image);
}

INSTANTIATE_TEST_SUITE_P(Samples, Guise, testing::Values(0, 1, 2), [](const auto& info) {
  return std::string(info.param == 0 ? "planar" : info.param == 1 ? "spatial" : "truck");
});

TEST(Invariance, ADriverOfASharedPointIsThatOfTheFirstBodyThatCarriesIt) {
  // B is on crank and coupler. Listed first, the crank is driven and a group of its own; listed
  // second, it is solved with the coupler. The motion is the same.
  const auto described = [](bool crank_first) {
    Sketch d("by abscissa", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0});
    const int crank = crank_first ? d.body("crank", {A, B}) : -1;
    const int coupler = d.body("coupler", {B, C}), rocker = d.body("rocker", {D, C});
    const int first = crank_first ? crank : d.body("crank", {A, B});
    d.revolute(Sketch::ground, first, A);
    d.revolute(first, coupler, B);
    d.revolute(coupler, rocker, C);
    d.revolute(Sketch::ground, rocker, D);
    d.component("Bx", B, 0).driven = true;
    return d.take();
  };
  const std::vector<Motion> abscissa{Polynomial{{std::cos(1.0), -0.5}}};
  const std::vector<double> times = instants(0.5);
  const Solved a(described(true), abscissa, times), b(described(false), abscissa, times);
  EXPECT_EQ(a.mechanism().structural_groups(), 2);
  EXPECT_EQ(a.mechanism().groups[0].bodies, std::vector<std::string>{"crank"});
  EXPECT_EQ(b.mechanism().structural_groups(), 1);
  for (int k = 0; k < a.instants() && !HasFailure(); ++k)
    expect_near(b.position(k, "C"), a.position(k, "C"), 1e-11, "C");
}

}  // namespace
}  // namespace desmo
