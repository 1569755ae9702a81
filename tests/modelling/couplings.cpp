// Couplings: their equations and groups, what follows from them, and what they contradict.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "tests/modelling/common.h"
#include "tests/refusal.h"

namespace desmo::couplings_test {
namespace {

/// Returns wheels on the ground, of which the first is driven, with these numbers of teeth. Each
/// meshes with the next, and the last with the first.
Mechanism ring_of_gears(const std::vector<double>& teeth, double last_teeth) {
  Sketch d("ring", 2);
  const int n = static_cast<int>(teeth.size());
  for (int i = 0; i < n; ++i) {
    const std::string number = std::to_string(i + 1);
    const Vec at = polar(1, 2 * i);
    const int pivot = d.ground_point("O" + number, at),
              rim = d.point("A" + number, at + polar(0.1, 0.3 + i));
    d.body("wheel" + number, {pivot, rim});
    d.angle("turn" + number, line(pivot, rim)).driven = i == 0;
  }
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    d.couple("mesh" + std::to_string(i + 1),
             {{i, teeth[i]}, {next, next == 0 ? last_teeth : teeth[next]}});
  }
  return d.release_pinned();
}

/// Returns the misfit of the first coupling, as it is drawn, where Φ is 0.1.
Misfit misfit_of_coupling(const Model& m) {
  const auto is_coupling = [](const Constraint& c) { return c.name.ends_with(": coupling"); };
  const auto c = std::ranges::find_if(m.constraints, is_coupling);
  return misfit_of(m, static_cast<int>(c - m.constraints.begin()), 0, 0.1, m.state_of(m.estimate));
}

const DisplayUnits units{{"mm", 1e-3}, {"deg", std::numbers::pi / 180}};

TEST(Coupling, OfTwoWheelsPutsOneAfterTheOther) {
  Sketch d("wheels", 2);
  const int O = d.ground_point("O", {0, 0, 0}), P = d.ground_point("P", {3, 0, 0});
  const int A = d.point("A", {1, 0, 0}), B = d.point("B", {3, 2, 0});
  d.bodies({{"driven", {P, B}}, {"driver", {O, A}}});
  d.angle("b", line(P, B));
  d.angle("a", line(O, A)).driven = true;
  d.couple("mesh", {{0, 40}, {1, 20}});
  const ModellingResult r = model_mechanism(d.release_pinned(), turning);
  EXPECT_TRUE(std::ranges::none_of(r.left_out, &LeftOut::redundant));
  ASSERT_EQ(r.model.groups.size(), 2u);
  EXPECT_EQ(r.model.groups[0].bodies, std::vector<std::string>{"driver"});
  EXPECT_EQ(r.model.groups[1].after, std::vector<GroupId>{0});
  // 40 b + 20 a keeps 40 · π/2; Φ is in units of the largest factor.
  const auto equations = equations_of(r.model, 1);
  const auto mesh = std::ranges::find(equations, "coupling_2", &Stated::kind);
  ASSERT_NE(mesh, equations.end());
  EXPECT_EQ(mesh->operands, (std::vector<std::string>{"b", "a"}));
  EXPECT_EQ(mesh->constants, (std::vector<double>{1, 0.5, std::numbers::pi / 2}));
  const Misfit misfit = misfit_of_coupling(r.model);
  EXPECT_EQ(misfit.amount, 0.1);
  EXPECT_EQ(misfit.unit(units).name, "deg");
}

TEST(Coupling, OfAngleAndLengthHasTheUnitOfLength) {
  Sketch d("rack", 2);
  const int O = d.ground_point("O", {0, 1, 0}), M = d.ground_point("M", {0, 0, 0});
  const int x = d.ground_vector("x", {1, 0, 0});
  const int A = d.point("A", {1, 1, 0}), R = d.point("R", {2, 0, 0});
  const int pinion = d.body("pinion", {O, A}), rack = d.body("rack", {R}, {x});
  d.joint(JointType::revolute, Sketch::ground, pinion, {O});
  d.joint(JointType::prismatic, Sketch::ground, rack, {M, R}, {x});
  d.angle("a", line(O, A)).driven = true;
  d.along("s", M, R, x);
  d.couple("rack", {{0, -30}, {1, 4}});
  const Solved s(d.release(), {Polynomial{{0, 1}}}, std::array{0.0, 7.0});
  EXPECT_NEAR(s.scalar(1, "s"), 2 + 7 * 7.5, 1e-12);
  for (const Constraint& c : s.model().constraints)
    if (c.name == "rack: coupling") {
      EXPECT_EQ(values_of(c), (std::vector<double>{-7.5, 1, 2}));
    }
  const Misfit misfit = misfit_of_coupling(s.model());
  EXPECT_EQ(misfit.amount, 0.1);  // that of the length, although the slope by the angle is steeper
  EXPECT_EQ(misfit.unit(units).name, "mm");
}

TEST(Coupling, ThatFollowsFromOthersIsLeftOut) {
  const ModellingResult r = model_mechanism(ring_of_gears({20, 30, 50, 40}, 20), turning);
  std::vector<LeftOut> couplings;  // lengths follow from angles besides
  std::ranges::copy_if(r.left_out, std::back_inserter(couplings),
                       [](const LeftOut& l) { return l.equation.ends_with("coupling"); });
  ASSERT_EQ(couplings.size(), 1u);
  EXPECT_TRUE(couplings[0].redundant);
  std::vector<std::string> all = couplings[0].follows_from;
  all.push_back(couplings[0].equation);
  std::ranges::sort(all);
  EXPECT_EQ(all, (std::vector<std::string>{"mesh1: coupling", "mesh2: coupling", "mesh3: coupling",
                                           "mesh4: coupling"}));
}

TEST(Coupling, ThatContradictsOthersIsRefusedWithAllOfThem) {
  expect_refused(ring_of_gears({20, 30, 50}, 20), turning,
                 {"contradict each other as it moves", "'mesh1: coupling'", "'mesh2: coupling'",
                  "'mesh3: coupling'", "'turn1'"});
  expect_refused(ring_of_gears({20, 30, 50, 40}, 21), turning,
                 {"contradict", "'mesh1: coupling'", "'mesh2: coupling'", "'mesh3: coupling'",
                  "'mesh4: coupling'"});
}

/// One way leads out of the table; the other tells by how much they contradict each other.
TEST(Coupling, ThatContradictsOthersAtTheEndOfItsTableIsOffByANumber) {
  Mechanism mechanism = ring_of_gears({20, 30, 50}, 20);
  for (const double before : {0.1, 41.0}) {
    const double end = 30 * 1.3 - before;  // of the arguments, near where turn2 is drawn, or not
    mechanism.couplings[0].table = {
        {end, end + 41.1}, {0, -41.1}, SplineEnds::natural, std::nullopt};
    const std::string message = refusal([&] { model_mechanism(mechanism, turning); });
    EXPECT_NE(message.find("contradict each other as it moves"), std::string::npos) << message;
    EXPECT_NE(message.find("is off by 0."), std::string::npos) << message;
  }
}

TEST(Coupling, TakesAFreedom) {
  Mechanism mechanism = ring_of_gears({20, 30, 50, 40}, 20);
  mechanism.couplings.erase(mechanism.couplings.begin() + 1, mechanism.couplings.end());
  expect_refused(mechanism, turning, {"under-constrained: 2 freedoms among 'wheel3', 'wheel4'"});
}

TEST(Coupling, OfWhatIsMeaninglessIsRefused) {
  using Coupling = Mechanism::Coupling;
  using Numbers = std::vector<double>;
  const auto refused = [](std::string_view what, auto&& change) {
    Mechanism mechanism = ring_of_gears({20, 30, 50, 40}, 20);
    change(mechanism, mechanism.couplings[0]);
    const auto drivers =
        std::ranges::count(mechanism.coordinates, true, &Mechanism::Coordinate::driven);
    expect_refused(mechanism, std::vector<Motion>(drivers, still), {what});
  };
  refused("relates 5 coordinates; give two to four", [](Mechanism&, Coupling& c) {
    c.terms = {{0, 1.0}, {1, 1.0}, {2, 1.0}, {3, 1.0}, {0, 1.0}};
  });
  refused("coordinate that does not exist",
          [](Mechanism&, Coupling& c) { c.terms[1].coordinate = 9; });
  refused("given twice among the couplings",
          [](Mechanism& m, Coupling&) { m.couplings[1].name = "mesh1"; });
  refused("coupling 'mesh1': all its coordinates are driven",
          [](Mechanism& m, Coupling&) { m.coordinates[1].driven = true; });
  refused("2 times but 1", [](Mechanism&, Coupling& c) {
    c.table = {Numbers{0, 1}, Numbers{0}, SplineEnds::natural};
  });
  refused("outside of its table, from 70 to 80", [](Mechanism&, Coupling& c) {
    c.table = {Numbers{70, 80}, Numbers{0, 1}, SplineEnds::natural};
  });
  refused("has a table, and not two coordinates", [](Mechanism&, Coupling& c) {
    c.table = {Numbers{0, 1}, Numbers{0, 1}, SplineEnds::natural};
    c.terms.push_back({2, 1.0});
  });
}

}  // namespace
}  // namespace desmo::couplings_test
