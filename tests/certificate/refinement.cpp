// Refined instants against quadruple precision of the motion in the file.

#include "formulations/verification/certificate/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>

#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/containment.h"
#include "tests/dead_point.h"

namespace desmo::refinement_test {
namespace {

constexpr double u = 0x1p-53;

/// Largest errors of refined instants over what is promised, relative to scales; to the number
/// itself where that is larger, such as an angle after turns.
struct Errors {
  int proven = 0, passes = 0;
  PerLevel<double> share;

  void add(const Model& m, const RefinedInstant& refined, const ReferenceInstant& exact,
           const Scales& scales, double condition) {
    proven += refined.proven;
    passes = std::max(passes, refined.passes);
    const PerLevel<double> promised{(1 + 5e-4 * condition) * u,
                                    (1 + 2e-4 * condition * condition) * u,
                                    (1 + 2e-4 * condition * condition) * u};
    const PerLevel<std::span<const double>> values{refined.instant.q, refined.instant.qd,
                                                   refined.instant.qdd};
    for (const Level level : all_levels)
      for (const Entity& e : m.entities)
        for (int i = e.first; !e.fixed && i < e.first + e.size; ++i) {
          const double error = error_of(values[level][i], exact, level, i);
          EXPECT_LE(error, refined.radius[level][i]) << m.name << ' ' << e.name;
          const double scale = std::max(scales.of(e.kind, level), std::abs(values[level][i]));
          share[level] = std::max(share[level], relative(error, scale) / promised[level]);
        }
  }
};

Errors refine_all(const Model& m, std::span<const double> times, bool from_single) {
  const Reference reference = make_reference(m, times);
  auto solved = double_solution(m, times);
  if (from_single)
    for (ReferenceInstant& s : solved)
      for (std::vector<double>* values : {&s.q, &s.qd, &s.qdd})
        for (double& x : *values) x = static_cast<float>(x);
  ConditionNumber condition(m);
  Refinement refinement(m);
  Errors errors;
  for (std::size_t k = 0; k < times.size(); ++k)
    errors.add(m, refinement.refine(instant_of(solved[k])), reference.instants[k], reference.scales,
               condition(solved[k].q));
  std::cout << m.name << ": " << errors.passes << " passes, shares of what is promised "
            << errors.share.position << ", " << errors.share.velocity << ", "
            << errors.share.acceleration << '\n';
  return errors;
}

/// Errors of single precision leave others of their square, which a second pass takes off.
void expect_last_digits(const Scene& scene, bool from_single) {
  const int count = DESMO_SANITIZED ? 2 : 20;
  const Errors errors = refine_all(make_model(scene), sampled(scene.grid, count), from_single);
  EXPECT_EQ(errors.proven, count) << scene.mechanism.name;
  for (const Level level : all_levels) EXPECT_LE(errors.share[level], 1) << scene.mechanism.name;
}

TEST(Refinement, IsRightToTheLastDigits) {
  for (const bool from_single : {false, true})
    for (const Scene& scene : library_scenes()) expect_last_digits(scene, from_single);
  for (const Case& definition : cases())
    expect_last_digits(make_scene(definition, definition.sizes.front()), false);
}

/// Rates are linear, and found from zeros: also where nothing accelerates, or lengths alone do.
TEST(Refinement, FindsRatesFromPositionsAlone) {
  for (const Scene& scene : library_scenes()) {
    const Model m = make_model(scene);
    const ReferenceInstant s = double_solution(m, std::array{scene.grid.start}).front();
    const std::vector<double> zeros(m.coordinates());
    Refinement from_all(m), from_zeros(m);
    const RefinedInstant &all = from_all.refine(instant_of(s)),
                         &found = from_zeros.refine(instant_of(s.time, {s.q, zeros, zeros}));
    EXPECT_LE(all.passes, 2) << m.name;
    for (int i = 0; i < m.coordinates(); ++i) {
      EXPECT_LE(found.radius.velocity[i], 4 * all.radius.velocity[i] + 1e-15) << m.name << i;
      EXPECT_LE(found.radius.acceleration[i], 4 * all.radius.acceleration[i] + 1e-14)
          << m.name << i;
    }
  }
}

TEST(Refinement, HasRadiiOfTheLevelsOfTheInstantAlone) {
  const Scene scene = library_scene("slider_crank");
  const Model m = make_model(scene);
  const ReferenceInstant s = double_solution(m, std::array{scene.grid.start}).front();
  Refinement refinement(m);
  refinement.refine(instant_of(s));
  const RefinedInstant& r = refinement.refine(instant_of(s.time, {s.q, {}, {}}));
  ASSERT_TRUE(r.proven);
  EXPECT_FALSE(r.radius.position.empty());
  EXPECT_TRUE(r.radius.velocity.empty());
  EXPECT_TRUE(r.radius.acceleration.empty());
}

/// Rows between solved ones (Settings::stride) are far off where steps are long: digits double in
/// each pass, the first one has none.
TEST(Refinement, FindsPositionsThatAreFarOff) {
  const Model m = locking_four_bar(Polynomial{{dead_point - 1, 1}});
  const auto exact = reference_solution(m, std::array{0.0}, Precision::quadruple);
  const ReferenceInstant far = moved(m, exact.front(), 0.2);
  Refinement refinement(m);
  Errors errors;
  errors.add(m, refinement.refine(instant_of(far)), exact.front(), make_scales(m, exact), 10);
  EXPECT_EQ(errors.proven, 1);
  EXPECT_GT(errors.passes, 4);
  for (const Level level : all_levels) EXPECT_LE(errors.share[level], 2);
}

/// Velocities are rounding of the drivers there, which no pass makes smaller.
TEST(Refinement, CorrectsPositionsWhereAMotionRests) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = HarmonicSum{0.5, {{0.3, std::numbers::pi / 2, 0}}};
  ReferenceInstant s = double_solution(m, std::array{1.0}).front();
  for (double& q : s.q) q += 1e-3;
  Refinement refinement(m);
  const RefinedInstant& r = refinement.refine(instant_of(s));
  ASSERT_TRUE(r.proven);
  for (const double radius : r.radius.position) EXPECT_LE(radius, 1e-15);
}

/// The certificate of the last pass bounds numbers that are not delivered: the driver's is exact.
TEST(Refinement, BoundsNothingWithoutAProof) {
  const Model m = locking_four_bar(Polynomial{{dead_point, 1}});
  std::vector<double> q = m.estimate;
  for (double& x : q) x += 1e-3;
  const std::vector<double> zeros(m.coordinates());
  Refinement refinement(m);
  const RefinedInstant& r = refinement.refine(instant_of(0, {q, zeros, zeros}));
  ASSERT_FALSE(r.proven);
  for (const Level level : all_levels)
    for (const double radius : r.radius[level]) EXPECT_EQ(radius, INFINITY);
}

}  // namespace
}  // namespace desmo::refinement_test
