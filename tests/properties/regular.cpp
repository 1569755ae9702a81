// Regular positions of an overconstrained linkage that were called singular.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "cases/extremes/rows.h"
#include "cases/mechanism/builder.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/run/checked_run.h"
#include "tests/discard.h"

namespace desmo::properties::regular_test {
namespace {

const char* const ids[] = {"global_automatic_klu", "group_automatic_eigen",
                           "block_symbolic_inlined", "group_symbolic_explicit"};

/// Six links of length 1 whose axes are at right angles; every second angle is θ, the others φ with
/// cos θ + cos φ + cos θ cos φ = 0.
Mechanism bricard(double theta) {
  const double phi = std::acos(-std::cos(theta) / (1 + std::cos(theta)));
  MechanismBuilder b("bricard", 3);
  b.set_length_unit("1");
  std::vector<extremes::HingedLink> links;
  for (int i = 0; i < 3; ++i) {
    links.push_back({theta, 1, std::numbers::pi / 2});
    links.push_back({-phi, 1, -std::numbers::pi / 2});
  }
  const Mechanism::Vec end = extremes::add_linkage(b, links);
  EXPECT_NEAR(std::hypot(end[0], end[1], end[2]), 0, 1e-14);
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
