// Proven radii against quadruple precision, over motions of whole mechanisms.

#include <gtest/gtest.h>

#include <iostream>

#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/containment.h"
#include "tests/certificate/turned_chain.h"

namespace desmo::certified_mechanisms_test {
namespace {

Containment contain(const Model& m, std::span<const double> times,
                    ErrorSets sets = ErrorSets::boxes) {
  const auto solved = double_solution(m, times);
  const auto exact = reference_solution(m, times, Precision::quadruple);
  Certifier certifier(m);
  Containment c;
  for (std::size_t k = 0; k < times.size(); ++k) c.add(certifier, solved[k], exact[k], sets);
  std::cout << m.name << ", " << m.coordinates() << " coordinates: " << c.proven << " of "
            << c.instants << " proven;";
  for (const Level level : all_levels)
    std::cout << " widest " << c.widest[level] << ", " << c.median(level) << " times the error;";
  std::cout << '\n';
  return c;
}

void expect_held(const Scene& scene, int count) {
  Containment c = contain(make_model(scene), sampled(scene.grid, count));
  EXPECT_EQ(c.proven, c.instants) << scene.mechanism.name;
  EXPECT_LE(c.median(Level::position), DESMO_SANITIZED ? 200 : 50) << scene.mechanism.name;
}

TEST(Certificate, HoldsOnTheLibraryAndTheCases) {
  for (const Scene& scene : library_scenes()) expect_held(scene, DESMO_SANITIZED ? 5 : 100);
  for (const Case& c : cases())
    expect_held(make_scene(c, DESMO_SANITIZED ? c.sizes.front() : c.sizes.back()),
                DESMO_SANITIZED ? 2 : 20);
}

TEST(Certificate, HoldsWhateverTheUnit) {
  for (const double factor : {1e-9, 1e9}) {
    const Scene scene = enlarged(library_scene("slider_crank"), factor);
    const Containment c = contain(make_model(scene), sampled(scene.grid, 20));
    EXPECT_EQ(c.proven, c.instants) << factor;
  }
}

/// The driver is known to so few digits that the first box is too small for its errors. Some errors
/// of position are zero, which those of rates are not.
TEST(Certificate, HoldsAtLateTimes) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = Polynomial{{0, 10.473}};
  const Containment c = contain(m, sampled({1e5, 1.0 / 64, 9}, 9));
  EXPECT_EQ(c.proven, c.instants);
  EXPECT_GE(c.widest.position, 0x1p-36);
  EXPECT_LE(c.widest.velocity, 1e-8);
  EXPECT_LE(c.widest.acceleration, 1e-7);
}

/// Expects proofs in bases, and no radius above a limit.
void expect_narrow(const Model& m, const std::vector<double>& times, double limit) {
  const Containment c = contain(m, times, ErrorSets::bases);
  EXPECT_GT(c.instants, 0);
  EXPECT_EQ(c.proven, c.instants);
  for (const Level level : all_levels) EXPECT_LE(c.widest[level], limit);
}

/// The second has groups beside a chain that read what a basis encloses as boxes, and groups that
/// read two of these.
TEST(Certificate, HoldsOnTurnedChains) {
  struct Chain {
    int dyads;
    bool branched;
    TimeGrid grid;
    double limit;
  };
  for (const auto& [dyads, branched, grid, limit] :
       {Chain{DESMO_SANITIZED ? 30 : 185, false, {0, 0.25, 25}, 1e-10},
        Chain{12, true, {0, 0.25, 25}, 1e-10}, Chain{2000, false, {0, 1, 7}, 1e-8}})
    expect_narrow(make_model(turned_chain(dyads, branched)),
                  sampled(grid, DESMO_SANITIZED ? 2 : grid.instants), limit);
}

TEST(Certificate, HoldsOnAChainWhoseRatesAreLost) {
  const Model m = make_model(turned_chain(12, true));
  const std::vector<double> times = sampled({0, 0.25, 25}, DESMO_SANITIZED ? 2 : 25);
  const auto solved = double_solution(m, times);
  const auto exact = reference_solution(m, times, Precision::quadruple);
  const int lost = m.entities[m.find("dyad3/C")].first, last = m.entities[m.find("span/C")].first;
  Certifier certifier(m);
  Containment c;
  for (std::size_t k = 0; k < times.size(); ++k) {
    ReferenceInstant delivered = solved[k];
    delivered.qdd[lost] = INFINITY;
    const Certificate found = c.add(certifier, delivered, exact[k]);
    EXPECT_FALSE(found.proven);
    EXPECT_LE(found.radius.velocity[last], 1e-10);
    EXPECT_TRUE(std::isinf(found.radius.acceleration[last]));
    EXPECT_LE(found.radius.acceleration[m.entities[m.find("end/C")].first], 1e-10);
  }
}

/// Boxes do along eight groups, and cost less. Along 79, those of accelerations would grow to 3e-3.
TEST(Certificate, TakesBasesAlongLongChainsAlone) {
  for (const int dyads : {7, 78}) {
    SCOPED_TRACE(dyads);
    const Model m = make_model(turned_chain(dyads));
    expect_narrow(m, {3.5}, 1e-10);
    EXPECT_EQ(Certifier(m).has_long_chains(), dyads > 7);
  }
}

}  // namespace
}  // namespace desmo::certified_mechanisms_test
