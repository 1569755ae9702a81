// Regular positions that were called singular: of overconstrained linkages, and of mechanisms whose
// lengths differ.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "cases/mechanism/builder.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/run/checked_run.h"
#include "tests/discard.h"

namespace desmo::properties::regular_test {
namespace {

using Vec = Mechanism::Vec;
using enum Mechanism::JointType;
constexpr int ground = MechanismBuilder::ground;

const char* const ids[] = {"global_automatic_klu", "group_automatic_eigen",
                           "block_symbolic_inlined", "group_symbolic_explicit"};

/// Turns a vector about a unit vector at right angles.
Vec turned(const Vec& v, const Vec& about, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec across{about[1] * v[2] - about[2] * v[1], about[2] * v[0] - about[0] * v[2],
                   about[0] * v[1] - about[1] * v[0]};
  return {c * v[0] + s * across[0], c * v[1] + s * across[1], c * v[2] + s * across[2]};
}

/// Six links of length 1 whose axes are at right angles; every second angle is θ, the others φ with
/// cos θ + cos φ + cos θ cos φ = 0.
Mechanism bricard(double theta) {
  const double phi = std::acos(-std::cos(theta) / (1 + std::cos(theta)));
  MechanismBuilder b("bricard", 3);
  b.set_length_unit("1");
  Vec x{1, 0, 0}, z{0, 0, 1}, at{};
  std::vector<int> points, axes;
  for (int i = 0; i < 6; ++i) {
    points.push_back(b.point("P" + std::to_string(i + 1), at));
    axes.push_back(b.vector("z" + std::to_string(i + 1), z));
    x = turned(x, z, i % 2 == 0 ? theta : -phi);
    for (int k = 0; k < 3; ++k) at[k] += x[k];
    z = turned(z, x, (i % 2 == 0 ? 1 : -1) * std::numbers::pi / 2);
  }
  EXPECT_NEAR(std::hypot(at[0], at[1], at[2]), 0, 1e-14);
  const int u = b.vector("u", {1, 0, 0}), v = b.vector("v", {0, 1, 0});
  b.carry(ground, {points[5], points[0]}, {axes[5], axes[0], u, v});
  int last = ground;
  for (int i = 0; i < 5; ++i) {
    const int link =
        b.body("link" + std::to_string(i + 1), {points[i], points[i + 1]}, {axes[i], axes[i + 1]});
    b.joint(revolute, last, link, {points[i]}, {axes[i]});
    last = link;
  }
  b.joint(revolute, last, ground, {points[5]}, {axes[5]});
  Mechanism::Coordinate& driven = b.coordinate("theta", Mechanism::CoordinateType::angle);
  driven.of = {-1, points[0], points[1]};
  driven.from = {u, -1, -1};
  driven.towards = {v, -1, -1};
  driven.driven = true;
  return b.release();
}

TEST(Regular, BricardIsAtARightAngle) {
  const Motion through = Polynomial{{std::numbers::pi / 2, 1}};
  for (const double drawn_at : {1.2, std::numbers::pi / 2}) {
    const Model m = model_mechanism(bricard(drawn_at), std::vector{through}).model;
    for (const char* id : ids) {
      Discard observer;
      const CheckedSummary s =
          run_checked(*make_formulation(find_variant(id), m), {-0.375, 1. / 64, 49}, {}, observer);
      EXPECT_EQ(s.outcome(), Outcome::converged) << id << ": " << describe(s, m);
      EXPECT_EQ(s.instants, 49) << id;
    }
  }
}

/// A four-bar on an arm that hardly moves. Lengths in mm.
Mechanism on_an_arm(double arm) {
  MechanismBuilder b("on_an_arm", 2);
  b.set_length_unit("mm");
  constexpr double crank = 10, base = 40, coupler = 35, rocker = 25, theta = 1;
  const Vec a{arm, 0, 0}, d{arm, base, 0},
      pin{arm + crank * std::cos(theta), crank * std::sin(theta), 0};
  const double x = d[0] - pin[0], y = d[1] - pin[1], to = std::hypot(x, y);
  const double along = (coupler * coupler - rocker * rocker + to * to) / (2 * to),
               across = std::sqrt(coupler * coupler - along * along);
  const Vec c{pin[0] + (along * x - across * y) / to, pin[1] + (along * y + across * x) / to, 0};
  const int po = b.point("O", {}), pa = b.point("A", a), pd = b.point("D", d),
            pb = b.point("B", pin), pc = b.point("C", c);
  b.carry(ground, {po});
  const int whole = b.body("arm", {po, pa, pd}), ab = b.body("crank", {pa, pb}),
            bc = b.body("coupler", {pb, pc}), dc = b.body("rocker", {pd, pc});
  b.joint(revolute, ground, whole, {po});
  b.joint(revolute, whole, ab, {pa});
  b.joint(revolute, ab, bc, {pb});
  b.joint(revolute, bc, dc, {pc});
  b.joint(revolute, dc, whole, {pd});
  for (const auto& [name, from, towards] :
       {std::tuple("swing", po, pa), std::tuple("theta", pa, pb)}) {
    Mechanism::Coordinate& driven = b.coordinate(name, Mechanism::CoordinateType::angle);
    driven.of = {-1, from, towards};
    driven.driven = true;
  }
  return b.release();
}

TEST(Regular, AFourBarIsOnALongArm) {
  for (const double arm : {1e2, 1e4, 1e6}) {
    const std::vector<Motion> motions{Polynomial{{0, 0.1 / arm}}, Polynomial{{1, 1}}};
    const Model m = model_mechanism(on_an_arm(arm), motions).model;
    for (const char* id : ids) {
      Discard observer;
      const CheckedSummary s =
          run_checked(*make_formulation(find_variant(id), m), {0, 1. / 16, 49}, {}, observer);
      EXPECT_EQ(s.outcome(), Outcome::converged) << arm << ", " << id << ": " << describe(s, m);
    }
  }
}

}  // namespace
}  // namespace desmo::properties::regular_test
