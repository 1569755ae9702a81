// Regular positions of an overconstrained linkage that were called singular.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases/extremes/rows.h"
#include "cases/mechanism/builder.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/run/checked_run.h"
#include "tests/discard.h"

namespace desmo::properties::regular_test {
namespace {

using Vec = Mechanism::Vec;

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
  const int x_axis = b.vector("u", {1, 0, 0}), y_axis = b.vector("v", {0, 1, 0});
  extremes::hinge_loop(b, "link", points, axes, x_axis, y_axis);
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

}  // namespace
}  // namespace desmo::properties::regular_test
