// What solved positions satisfy beyond the equations solved, and how it is told when they do not.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "cases/cases.h"
#include "cases/files.h"
#include "formulations/branch_monitor.h"
#include "formulations/modelling/model.h"
#include "tests/describing.h"

namespace desmo {
namespace {

/// One instant of a whole mechanism, to be tampered with.
class Position {
 public:
  explicit Position(Mechanism whole) : plan(make_plan(whole, {})) {
    const auto f = make_formulation(find_variant("global_automatic_eigen"), plan.mechanism,
                                    Settings{1e-11, 50});
    EXPECT_TRUE(f->step(0).ok());
    q.assign(f->q().begin(), f->q().end());
    qd.assign(f->qd().begin(), f->qd().end());
  }
  double& scalar(const std::string& name) {
    return q[plan.mechanism.entities[plan.mechanism.find(name)].first];
  }
  Constraint& constraint(const std::string& name) {
    return *std::ranges::find(plan.mechanism.constraints, name, &Constraint::name);
  }
  /// The constraint that the monitor names; empty: none.
  std::string violated(bool with_velocity = true) {
    BranchMonitor monitor(plan);
    const int c = monitor.violated(
        {0, 0, q, with_velocity ? std::span<const double>(qd) : std::span<const double>(), {}});
    return c < 0 ? "" : plan.mechanism.constraints[c].name;
  }

  Plan plan;
  std::vector<double> q, qd;
};

Description crank() {
  Sketch d("crank", 2);
  const int A = d.ground_point("A", {0, 0, 0}), B = d.point("B", polar(1, 1));
  d.revolute(Sketch::ground, d.body("crank", {A, B}), A);
  d.angle("theta", segment(A, B)).driven = true;
  d.angle("back", segment(B, A));
  return d.take();
}

const std::vector<Motion> turning{Polynomial{{1, 2}}};

TEST(Branch, OfAnAngleThatIsToldModuloPi) {
  Position planar(model(crank(), turning).mechanism);
  EXPECT_EQ(planar.violated(), "");
  planar.scalar("back") += 2 * std::numbers::pi;
  EXPECT_EQ(planar.violated(), "");
  planar.scalar("back") += std::numbers::pi;  // its equation still holds
  EXPECT_EQ(planar.violated(), "back: definition");

  Position spatial(make_mechanism(library_scene("rssr")));
  EXPECT_EQ(spatial.violated(), "");
  spatial.scalar("psi") += std::numbers::pi;
  EXPECT_EQ(spatial.violated(), "psi: definition");
}

TEST(Branch, OfEquationsLeftOut) {
  Position p(model(crank(), turning).mechanism);
  p.constraint("theta: definition").left_out = 2;  // its sine
  EXPECT_EQ(p.violated(), "");
  const int B = p.plan.mechanism.entities[p.plan.mechanism.find("B")].first;
  p.qd[B + 1] = -p.qd[B + 1];
  EXPECT_EQ(p.violated(), "theta: definition");
  EXPECT_EQ(p.violated(false), "");
  p.q[B + 1] = -p.q[B + 1];  // the cosine is the same
  EXPECT_EQ(p.violated(false), "theta: definition");
}

TEST(Branch, OfNoPositionAtAll) {
  Position p(model(crank(), turning).mechanism);
  p.scalar("back") = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(p.violated(), "back: definition");
}

}  // namespace
}  // namespace desmo
