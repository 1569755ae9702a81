// What solved positions satisfy beyond the equations solved, and how it is told when they do not.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/planning/plan.h"
#include "formulations/verification/monitor/branch_monitor.h"
#include "tests/describing.h"

namespace desmo::branch_test {
namespace {

/// One instant of a whole mechanism, to be tampered with.
class Position {
 public:
  explicit Position(Model whole) : plan(make_plan(whole, {})) {
    const auto f =
        make_formulation(find_variant("global_automatic_eigen"), plan.model, Settings{1e-11, 50});
    EXPECT_TRUE(f->step(0).ok());
    q.assign(f->q().begin(), f->q().end());
    qd.assign(f->qd().begin(), f->qd().end());
  }
  double& scalar(const std::string& name) {
    return q[plan.model.entities[plan.model.find(name)].first];
  }
  Constraint& constraint(const std::string& name) {
    return *std::ranges::find(plan.model.constraints, name, &Constraint::name);
  }
  /// The constraint that the monitor names; empty: none.
  std::string violated(bool with_velocity = true, double tolerance = 1e-11,
                       bool angles_follow = false) {
    BranchMonitor monitor(plan.model, plan.levels, tolerance);
    const int c = monitor.violated(
        {0, 0, q, with_velocity ? std::span<const double>(qd) : std::span<const double>(), {}},
        angles_follow);
    return c < 0 ? "" : plan.model.constraints[c].name;
  }

  Plan plan;
  std::vector<double> q, qd;
};

Mechanism crank() {
  Sketch d("crank", 2);
  const int A = d.ground_point("A", {0, 0, 0}), B = d.point("B", polar(1, 1));
  d.revolute(Sketch::ground, d.body("crank", {A, B}), A);
  d.angle("theta", line(A, B)).driven = true;
  d.angle("back", line(B, A));
  return d.release();
}

const std::vector<Motion> turning{Polynomial{{1, 2}}};

TEST(Branch, OfAnAngleThatIsToldModuloPi) {
  Position planar(model_mechanism(crank(), turning).model);
  EXPECT_EQ(planar.violated(), "");
  planar.scalar("back") += 2 * std::numbers::pi;  // its equation still holds
  EXPECT_EQ(planar.violated(), "back: definition");
  planar.scalar("back") -= 3 * std::numbers::pi;
  EXPECT_EQ(planar.violated(), "back: definition");

  Position spatial(make_model(library_scene("rssr")));
  EXPECT_EQ(spatial.violated(), "");
  spatial.scalar("psi") += std::numbers::pi;
  EXPECT_EQ(spatial.violated(), "psi: definition");
}

TEST(Branch, WhatCannotFailAloneIsNotCheckedWhereAnglesFollow) {
  Position p(model_mechanism(crank(), turning).model);
  Constraint& length = p.constraint("crank: A-B length");
  ASSERT_NE(length.left_out, 0u);
  EXPECT_TRUE(is_implied(p.plan.model, length));  // by the definition of theta
  p.scalar("back") += std::numbers::pi;
  EXPECT_EQ(p.violated(true, 1e-11, true), "");
  p.scalar("back") -= std::numbers::pi;

  length.constants[0] *= 1.01;  // of another crank
  EXPECT_FALSE(is_implied(p.plan.model, length));
  EXPECT_EQ(p.violated(true, 1e-11, true), "crank: A-B length");
}

TEST(Branch, OfEquationsLeftOut) {
  Position p(model_mechanism(crank(), turning).model);
  p.constraint("theta: definition").left_out = 2;  // its sine
  p.constraint("crank: A-B length").left_out = 0;
  EXPECT_EQ(p.violated(), "");
  const int B = p.plan.model.entities[p.plan.model.find("B")].first;
  p.qd[B + 1] = -p.qd[B + 1];
  EXPECT_EQ(p.violated(), "theta: definition");
  EXPECT_EQ(p.violated(false), "");
  p.q[B + 1] = -p.q[B + 1];  // the cosine is the same
  EXPECT_EQ(p.violated(false), "theta: definition");
}

/// What positions are solved short of their solution is not another branch.
TEST(Branch, LeavesEquationsLeftOutAsMuchAsTheTolerance) {
  Position p(model_mechanism(crank(), turning).model);
  p.constraint("theta: definition").left_out = 2;  // its sine
  p.constraint("crank: A-B length").left_out = 0;
  const int B = p.plan.model.entities[p.plan.model.find("B")].first;
  p.q[B + 1] *= 1 + 1e-5;
  EXPECT_EQ(p.violated(), "theta: definition");
  EXPECT_EQ(p.violated(true, 1e-7), "");
  p.q[B + 1] = -p.q[B + 1];
  EXPECT_EQ(p.violated(false, 1e-2), "theta: definition");
  EXPECT_EQ(p.violated(false, 1), "theta: definition");
}

TEST(Branch, OfConstraintsLeftOutWhole) {
  Position p(model_mechanism(crank(), turning).model);
  const int B = p.plan.model.entities[p.plan.model.find("B")].first;
  p.constraint("theta: definition").left_out = 3;  // as if its length were all that is solved
  p.constraint("crank: A-B length").left_out = 0;
  p.q[B] = 0, p.q[B + 1] = 1;
  EXPECT_EQ(p.violated(false), "theta: definition");
}

/// Three equal cranks fold into one line, from where the third is not held by what was kept.
TEST(Branch, OfRedundantCranksIsLeftWhereTheyFold) {
  Sketch d("locomotive", 2);
  std::vector<int> feet, ends;
  for (const double x : {0., 2., 5.}) {
    const std::string n = std::to_string(feet.size());
    feet.push_back(d.ground_point("D" + n, {x, 0, 0}));
    ends.push_back(d.point("C" + n, Vec{x, 0, 0} + polar(1, 1)));
  }
  const int coupler = d.body("coupler", ends);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const int crank = d.body("crank" + std::to_string(i), {feet[i], ends[i]});
    d.revolute(Sketch::ground, crank, feet[i]);
    d.revolute(crank, coupler, ends[i]);
  }
  d.angle("theta", line(feet[0], ends[0])).driven = true;
  const Plan plan = make_plan(model_mechanism(d.release(), {Polynomial{{1, 1}}}).model, {});
  const auto f =
      make_formulation(find_variant("block_automatic_klu"), plan.model, Settings{1e-10, 25});
  BranchMonitor monitor(plan.model, plan.levels, 1e-10);
  const auto length3 = [&] {
    const int c = plan.model.entities[plan.model.find("C2")].first;
    return std::hypot(f->q()[c] - 5, f->q()[c + 1]);
  };
  for (int i = 0; i < 500; ++i) {
    if (!f->step(0.01 * i).ok()) return;
    const bool rigid = std::abs(length3() - 1) < 1e-5;
    const int c = monitor.violated({i, 0.01 * i, f->q(), f->qd(), f->qdd()});
    if (c >= 0) return;  // told
    ASSERT_TRUE(rigid) << "t = " << 0.01 * i << ": " << length3();
  }
}

TEST(Branch, OfNoPositionAtAll) {
  Position p(model_mechanism(crank(), turning).model);
  p.scalar("back") = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(p.violated(), "back: definition");
}

}  // namespace
}  // namespace desmo::branch_test
