// The equations of the design pages: what the modeller must find, typed from them.

#include <gtest/gtest.h>

#include <set>

#include "tests/modelling/common.h"

namespace desmo::equations_test {
namespace {

void expect_unknowns(const Model& m, GroupId g, std::set<std::string> expected) {
  std::set<std::string> actual;
  const std::vector<bool> driven = independent_coordinates(m);
  for (const Entity& e : m.entities)
    if (!e.fixed && e.group == g && !driven[e.first]) actual.insert(e.name);
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
    normal_to_line("y1", "R", "S");
    unit("n3"), dot("n3", "y1"), normal_to_line("n3", "R", "S");
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
    normal_to_line("y2", A, B);
    unit(n), dot(n, "y2"), normal_to_line(n, A, B);
    state("rigid3_1", {B, A, e}, {std::sqrt(0.3 * 0.3 + 0.05 * 0.05)});
    state("frame_angle", {"x2", "z2", A, B, "phi" + lever}, {});
    const std::string G = "G" + link, u = "u" + link, m = "n" + link;
    length(G, B, 0.05 * 0.05 + 0.4 * 0.4);
    unit(u), dot(u, e), normal_to_line(u, G, B);
    unit(m), dot(m, u), normal_to_line(m, G, B);
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
  void normal_to_line(const std::string& u, const std::string& a, const std::string& b) {
    state("projection3", {u, a, b}, {0});
  }
  /// Length, three equations for u, normal to `other` too, and three for n.
  void rod(const char* G, const char* C, const char* u, const char* n, const char* other) {
    length(G, C, 0.8 * 0.8 + 0.05 * 0.05);
    unit(u), dot(u, other), normal_to_line(u, G, C);
    unit(n), dot(n, u), normal_to_line(n, G, C);
  }
  std::vector<Stated> take() { return std::exchange(stated_, {}); }

  std::string prefix_;
  std::vector<Stated> stated_;
};

TEST(TruckSuspension, HasExactlyTheEquationsOfItsDesign) {
  for (const int axles : {1, 5}) {
    const Model m = truck_model(axles);
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
    const std::vector<LeftOut> left_out = model_mechanism(s.mechanism, s.motions).left_out;
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
    const Model m = four_bar_model(dyads);
    EXPECT_EQ(m.coordinates(), 3 + 3 * dyads);
    ASSERT_EQ(m.groups.size(), 1u + dyads);
    ASSERT_EQ(m.drivers.size(), 1u);
    EXPECT_EQ(m.entities[m.drivers[0].coordinate].name, "crank/theta");
    expect_equations(m, 0, {{"planar_angle", {"crank/A", "crank/B", "crank/theta"}, {2}}});
    expect_unknowns(m, 0, {"crank/B"});
    EXPECT_EQ(m.groups[0].name, "SG-I");
    std::string b = "crank/B";
    for (int k = 1; k <= dyads; ++k) {
      const std::string dyad = "dyad" + std::to_string(k) + "/";
      const std::string c = dyad + "C", d = dyad + "D", psi = dyad + "psi";
      expect_equations(m, k, {{"length2", {b, c}, {36}}, {"planar_angle", {d, c, psi}, {6}}});
      expect_unknowns(m, k, {c, psi});
      EXPECT_EQ(m.groups[k].name, dyad + "SG-I");
      b = c;
    }
  }
}

TEST(FourBar, LeavesOutTheLengthsThatAnglesDefine) {
  for (const int dyads : {1, 185}) {
    const Scene s = four_bar(dyads);
    const ModellingResult modelled = model_mechanism(s.mechanism, s.motions);
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

}  // namespace
}  // namespace desmo::equations_test
