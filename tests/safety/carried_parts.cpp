// Small mechanisms that large ones carry: their branch and their rank, in their own lengths.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/extremes/rows.h"
#include "cases/mechanism/builder.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "tests/discard.h"

namespace desmo {
namespace {

constexpr const char* ids[] = {"global_automatic_klu", "group_automatic_lapack",
                               "group_symbolic_explicit", "block_automatic_eigen",
                               "block_symbolic_inlined"};

/// Returns a four-bar with links of 60 mm, or as many times that, at the end of an arm [m] that
/// turns [rad/s].
Scene on_arm(double arm, double rate, double times = 1) {
  const std::vector<ExtremeCase> cases = extremes::scales(Extent::brief);
  Scene scene = std::ranges::find(cases, "60 mm on an arm of 10 km", &ExtremeCase::name)->scene;
  for (Mechanism::Point& p : scene.mechanism.points)
    if (p.name != "O") {
      p.position[0] = arm + times * (p.position[0] - 1e4);
      p.position[1] *= times;
    }
  scene.motions[0] = Polynomial{{0, rate}};
  return scene;
}

/// Keeps which side of the line from B to D the point C lies on, of instants where that can be
/// told.
class Sides final : public Observer {
 public:
  explicit Sides(const Model& m)
      : b_(m.entities[m.find("B")].first),
        c_(m.entities[m.find("C")].first),
        d_(m.entities[m.find("D")].first) {}
  Flow observe(const Instant& i) noexcept override {
    const auto across = [&](int p, int q, int r) {
      return (i.q[q] - i.q[p]) * (i.q[r + 1] - i.q[p + 1]) -
             (i.q[q + 1] - i.q[p + 1]) * (i.q[r] - i.q[p]);
    };
    (across(b_, d_, c_) > 0 ? left : right) += 1;
    return Flow::go_on;
  }
  int left = 0, right = 0;

 private:
  int b_, c_, d_;
};

/// A step moves the arm by up to 8e6 links. Assembled from there, they may be their mirror
/// image.
TEST(CarriedParts, StayOnTheirBranch) {
  constexpr double max_speed = 1.1e7;  // m/s; beyond, a first step may be flagged
  for (const double arm : {1e2, 1e3, 1e4, 1e5, 1e6, 1e8})
    for (const double rate : {1.0, 0.1, 0.01}) {
      if (arm * rate > max_speed) continue;
      const Scene scene = on_arm(arm, rate);
      const Model m = make_model(scene);
      for (const char* id : ids) {
        Sides sides(m);
        const MonitoredSummary s =
            run_monitored(*make_formulation(find_variant(id), m), scene.grid, {}, sides);
        EXPECT_EQ(s.outcome(), Outcome::converged) << id << ", " << arm << " m, " << rate;
        EXPECT_EQ(sides.right, 0) << id << ", " << arm << " m, " << rate;
        EXPECT_EQ(sides.left, scene.grid.instants) << id << ", " << arm << " m, " << rate;
      }
    }
}

/// Rounding of 1e6 m is 1e-7 of these links.
TEST(CarriedParts, AreDeterminedAsFarAsRoundingTells) {
  const Scene scene = on_arm(1e6, 0.1, 0.025);
  const Model m = make_model(scene);
  for (const char* id : ids) {
    Sides sides(m);
    const MonitoredSummary s =
        run_monitored(*make_formulation(find_variant(id), m), scene.grid, {}, sides);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_EQ(sides.right, 0) << id;
  }
}

/// It is 1e-5 of these. They are refused, or not, but never for a singular position.
TEST(CarriedParts, AreRefusedForRoundingBeyondThat) {
  const Scene scene = on_arm(1e8, 0.1, 0.025);
  const Model m = make_model(scene);
  Discard observer;
  const MonitoredSummary s = run_monitored(
      *make_formulation(find_variant("block_automatic_eigen"), m), scene.grid, {}, observer);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  EXPECT_EQ(s.limit, Limit::sizes);
}

/// An estimate that is off by a twentieth of the links is assembled by them.
TEST(CarriedParts, AreAssembledFromAnEstimate) {
  Scene scene = on_arm(1e5, 0.1);
  std::ranges::find(scene.mechanism.points, "C", &Mechanism::Point::name)->position[0] += 3e-3;
  for (Mechanism::Body& body : scene.mechanism.bodies)
    if (body.name == "coupler") body.length = 0.0601;
  const Model m = make_model(scene);
  Discard observer;
  const MonitoredSummary s = run_monitored(
      *make_formulation(find_variant("global_automatic_klu"), m), scene.grid, {}, observer);
  EXPECT_EQ(s.outcome(), Outcome::converged);
}

/// A slider of a crank of 1 with a rod of 1.2, nominally this far from the point that its distance
/// is measured from.
Scene guided(double distance) {
  const double x = -0.8011436155469337, y = 0.5984721441039565,
               end = x + std::sqrt(1.44 - (y - 0.3) * (y - 0.3));
  MechanismBuilder d("guided", 2);
  const int a = d.point("A", {}), b = d.point("B", {x, y}), c = d.point("C", {end, 0.3}),
            e = d.point("E", {end - distance, 0.3}), along = d.vector("x", {1, 0});
  d.carry(MechanismBuilder::ground, {a, e}, {along});
  const int bodies[] = {d.body("crank", {a, b}), d.body("rod", {b, c}),
                        d.body("slider", {c}, {along})};
  using enum Mechanism::JointType;
  d.joint(revolute, MechanismBuilder::ground, bodies[0], {a});
  d.joint(revolute, bodies[0], bodies[1], {b});
  d.joint(revolute, bodies[1], bodies[2], {c});
  d.joint(prismatic, MechanismBuilder::ground, bodies[2], {e, c}, {along});
  Mechanism::Coordinate& angle = d.coordinate("theta", Mechanism::CoordinateType::angle);
  angle.of = {-1, a, b};
  angle.driven = true;
  Mechanism::Coordinate& s = d.coordinate("s", Mechanism::CoordinateType::along);
  s.of = {-1, e, c};
  s.vector = along;
  return {"guided", d.release(), {Polynomial{{2.5, 0.5}}}, {0, 0.02, 51}, {}, {}};
}

TEST(CarriedParts, MayBeNearlyZeroAtFirst) {
  for (const double distance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const Scene scene = guided(distance);
    const Model m = make_model(scene);
    Discard observer;
    const MonitoredSummary s = run_monitored(
        *make_formulation(find_variant("global_automatic_klu"), m), scene.grid, {}, observer);
    EXPECT_EQ(s.outcome(), Outcome::converged) << distance;
  }
  try {
    static_cast<void>(make_model(guided(1e-14)));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("rounding of its positions"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace desmo
