// Near singular positions and with wrong numbers: not proven, or a radius that holds.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "formulations/model/plan.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/containment.h"
#include "tests/dead_point.h"

namespace desmo::certified_singular_test {
namespace {

/// Adds noise of that size to all numbers but the driven ones.
void disturb(const Model& m, ReferenceInstant& instant, double size, std::mt19937& generator) {
  std::uniform_real_distribution<double> noise(-size, size);
  const std::vector<bool> driven = independent_coordinates(m);
  for (auto* values : {&instant.q, &instant.qd, &instant.qdd})
    for (std::size_t i = 0; i < values->size(); ++i)
      if (!driven[i]) (*values)[i] += noise(generator);
}

TEST(CertificateNearADeadPoint, IsWiderOrGivenUp) {
  int proven = 0, given_up = 0;
  for (const double distance : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-14, 1e-15}) {
    const Model m = locking_four_bar(Polynomial{{dead_point - distance, 1}});
    const auto exact = reference_solution(m, std::array{0.0}, Precision::quadruple);
    Certifier certifier(m);
    std::mt19937 generator(1);
    for (const double noise : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
      ReferenceInstant delivered = exact.front();
      disturb(m, delivered, noise, generator);
      Containment c;
      const Certificate found = c.add(certifier, delivered, exact.front());
      (found.proven ? proven : given_up) += 1;
      if (!found.proven) {
        EXPECT_EQ(m.groups[found.group].name, m.groups[m.entities[m.find("dyad1/C")].group].name);
      }
      // The other position is as far away as the square root of the distance.
      if (noise == 0 && distance >= 1e-13) {
        EXPECT_TRUE(found.proven) << distance;
      }
      if (noise > 10 * std::sqrt(distance)) {
        EXPECT_FALSE(found.proven) << distance;
      }
    }
  }
  EXPECT_GT(proven, 10);
  EXPECT_GT(given_up, 5);
}

TEST(CertificateAtADeadPoint, IsGivenUp) {
  const Model m = locking_four_bar(Polynomial{{dead_point}});
  const std::vector<double> zero(m.coordinates());
  std::vector<double> q = m.estimate;
  Certifier certifier(m);
  const Certificate c = certifier.certify({.index = 0, .time = 0, .q = q, .qd = zero, .qdd = zero});
  EXPECT_FALSE(c.proven);
  EXPECT_EQ(c.failure, ProofFailure::singular);
  EXPECT_TRUE(std::isinf(c.condition));
  const Entity& pin = m.entities[m.find("dyad1/C")];
  EXPECT_EQ(c.group, pin.group);
  EXPECT_EQ(c.worst_conditioned, pin.group);
  for (const Level level : all_levels) {
    EXPECT_TRUE(std::isinf(c.radius[level][pin.first]));
    // The crank comes before, and is not in doubt.
    EXPECT_LT(c.radius[level][m.entities[m.find("crank/B")].first], 1e-14);
  }
}

TEST(CertificateOfWrongNumbers, IsGivenUpWhereTheyAreNotFinite) {
  const Scene scene = library_scene("slider_crank");
  const Model m = make_model(scene);
  const auto solved = double_solution(m, std::array{0.1});
  Certifier certifier(m);
  for (int i = 0; i < m.coordinates(); ++i) {
    ReferenceInstant broken = solved.front();
    broken.q[i] = NAN;
    EXPECT_FALSE(certifier.certify(instant_of(broken.time, {broken.q})).proven) << i;
    broken = solved.front();
    broken.qd[i] = INFINITY;
    const Certificate c = certifier.certify(instant_of(broken.time, {broken.q, broken.qd}));
    EXPECT_FALSE(c.proven) << i;
    for (const double radius : c.radius.position) EXPECT_TRUE(std::isfinite(radius));
  }
}

TEST(CertificateOfAPlan, EndsAtTheLevelsThatAreSolved) {
  const Scene scene = library_scene("truck_axle");
  const Model whole = make_model(scene);
  const std::vector<Output> asked{{whole.constraints.back().operands.front(), Level::velocity}};
  const Plan plan = make_plan(whole, asked);
  ReferenceInstant s = double_solution(plan.model, std::array{0.1}).front();
  const std::vector<bool> driven = independent_coordinates(plan.model);
  for (int i = 0; i < plan.model.coordinates(); ++i)
    if (!driven[i]) s.qdd[i] = NAN;  // nobody has solved them
  Certifier certifier(plan.model, plan.levels);
  const Certificate c = certifier.certify(instant_of(s));
  EXPECT_TRUE(c.proven);
  for (int i = 0; i < plan.model.coordinates(); ++i) {
    EXPECT_LT(c.radius.velocity[i], 1e-9);
    EXPECT_EQ(std::isinf(c.radius.acceleration[i]), !driven[i]);
  }
}

TEST(CertificateOfLiveDrivers, CountsThemAsExact) {
  const Scene scene = library_scene("slider_crank");
  const Model m = make_model(scene);
  const ReferenceInstant s = double_solution(m, std::array{0.1}).front();
  const Instant instant = instant_of(s);
  const int driven = m.entities[m.drivers.front().coordinate].first;
  const std::vector<double> z{s.q[driven]}, zd{s.qd[driven]}, zdd{s.qdd[driven]};
  Certifier certifier(m);
  const Certificate c = certifier.certify(instant, {s.time, z, zd, zdd});
  EXPECT_TRUE(c.proven);
  EXPECT_LT(c.radius.position[driven], 1e-100);
  const std::vector<double> other{z[0] + 1e-6};
  EXPECT_NEAR(certifier.certify(instant, {s.time, other, zd, zdd}).radius.position[driven], 1e-6,
              1e-15);
  EXPECT_TRUE(certifier.certify(instant).proven);
  const std::vector<double> nowhere{NAN};
  EXPECT_FALSE(certifier.certify(instant, {s.time, nowhere, zd, zdd}).proven);
}

}  // namespace
}  // namespace desmo::certified_singular_test
