// Steps of whole motions: proven where they continue the motion, with all of it inside the tube;
// never where they end elsewhere.

#include "formulations/verification/certificate/path_proof.h"

#include <gtest/gtest.h>

#include <iostream>
#include <numbers>

#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/certificate/certificate.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/containment.h"

namespace desmo::path_proof_test {
namespace {

/// Returns instants of a model, certified.
std::vector<InstantCopy> certified(const Model& m, const std::vector<ReferenceInstant>& solved) {
  Certifier certifier(m);
  std::vector<InstantCopy> all(solved.size());
  for (std::size_t k = 0; k < solved.size(); ++k) {
    const ReferenceInstant& s = solved[k];
    all[k].assign({s.time, {s.q, s.qd, s.qdd}, certifier.certify(instant_of(s)).radius.position});
  }
  return all;
}

/// Returns an instant up to a level.
CertifiedInstant up_to(Level level, const InstantCopy& instant) {
  CertifiedInstant at = instant.view();
  if (level < Level::acceleration) at.values.acceleration = {};
  if (level < Level::velocity) at.values.velocity = {};
  return at;
}

struct Tally {
  int steps = 0, proven = 0;
  double widest = 0;  // tube over the largest coordinate
};

/// Proves steps of a length [s] that begin at some times; each has `inner` solutions between its
/// ends, which the tube is to hold.
Tally prove_steps(const Model& m, const std::vector<double>& begins, double length, int inner,
                  Level level = Level::acceleration) {
  std::vector<double> times;
  for (const double t : begins)
    for (int i = 0; i <= inner + 1; ++i) times.push_back(t + length * i / (inner + 1));
  std::ranges::sort(times);
  const std::vector<InstantCopy> at = certified(m, double_solution(m, times));
  const Certifier blocks(m);
  PathProof path(m, blocks);
  Tally tally;
  const std::size_t stride = inner + 1;
  for (std::size_t k = 0; k + stride < times.size(); k += stride + 1) {
    ++tally.steps;
    if (!path.prove(up_to(level, at[k]), up_to(level, at[k + stride])).proven) continue;
    ++tally.proven;
    for (std::size_t j = k; j <= k + stride; ++j)
      for (int i = 0; i < m.coordinates(); ++i) {
        constexpr double solved_to = 1e-12;  // of the solutions in between
        const double q = at[j].values.position[i], tube = path.radius(i);
        EXPECT_LE(std::abs(q - path.centre(i, times[j])), tube + solved_to * (1 + std::abs(q)))
            << m.name << ", coordinate " << i << " at " << times[j];
        tally.widest = std::max(tally.widest, tube / (1 + std::abs(q)));
      }
  }
  std::cout << m.name << ": " << tally.proven << " of " << tally.steps << ", widest "
            << tally.widest << '\n';
  return tally;
}

std::vector<double> begins_of(const Scene& scene, double step, int count) {
  std::vector<double> times;
  const double begin = scene.grid.start, end = scene.grid.time(scene.grid.instants - 1) - step;
  for (int i = 0; i < count; ++i) times.push_back(begin + (end - begin) * i / count);
  return times;
}

TEST(PathProof, ProvesEachStepOfTheLibrary) {
  for (const Scene& scene : library_scenes()) {
    const Model m = make_model(scene);
    const double step = scene.grid.interval();
    for (const Level level : all_levels) {
      const Tally t =
          prove_steps(m, begins_of(scene, step, DESMO_SANITIZED ? 1 : 20), step, 3, level);
      if (level >= Level::velocity) {
        EXPECT_EQ(t.proven, t.steps) << m.name;
      }
    }
  }
}

TEST(PathProof, ProvesEachStepOfTheCases) {
  for (const Case& definition : cases()) {
    const Scene scene = make_scene(definition, definition.sizes.back());
    const Tally t =
        prove_steps(make_model(scene), begins_of(scene, 0.01, DESMO_SANITIZED ? 1 : 8), 0.01, 2);
    EXPECT_EQ(t.proven, t.steps) << definition.name;
  }
}

/// Coordinates that are solved up to different levels have the paths of these, also the last ones,
/// which fill no register.
TEST(PathProof, TakesTheLevelOfEachCoordinate) {
  int odd = 0;
  for (const Scene& scene : library_scenes()) {
    const Model m = make_model(scene);
    const double t = scene.grid.start;
    const auto at = certified(m, double_solution(m, std::vector{t, t + scene.grid.interval()}));
    const Certifier blocks(m);
    PathProof mixed(m, blocks), same(m, blocks);
    std::vector<Level> levels;
    for (int i = 0; i < m.coordinates(); ++i) levels.push_back(all_levels[(i + i / 4) % 3]);
    static_cast<void>(mixed.prove(at[0].view(levels), at[1].view()));
    odd += m.coordinates() % 4 != 0;
    for (const Level level : all_levels) {
      static_cast<void>(same.prove(up_to(level, at[0]), up_to(level, at[1])));
      for (int i = 0; i < m.coordinates(); ++i)
        if (levels[i] == level) EXPECT_EQ(mixed.path(i), same.path(i)) << m.name << ' ' << i;
    }
  }
  EXPECT_GT(odd, 0);
}

/// Drivers turn back within steps of a crank that oscillates, which polynomials in time hold. At
/// late times few digits are left of an angle.
TEST(PathProof, HoldsDriversThatTurnBackAndLateTimes) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = HarmonicSum{.mean = 0.7, .terms = {{0.3, 2 * std::numbers::pi, 0}}};
  EXPECT_EQ(prove_steps(m, {0.24, 0.74}, 0.02, 3).proven, 2);
  m.drivers[0].motion = Polynomial{{0, 10.473}};
  EXPECT_EQ(prove_steps(m, {1e6, 1e6 + 0.125, 1e6 + 0.5}, 1.0 / 64, 1).proven, 3);
}

/// A step that contains a knot is none of one cubic.
TEST(PathProof, AsksForAStepThatEndsAtAKnot) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = make_spline({0, 1, 2}, {0.5, 0.7, 0.3}, SplineEnds::natural);
  const std::vector<double> times{0.98, 1, 1.02, 1.04, 2.5, 2.52};
  const std::vector<InstantCopy> at = certified(m, double_solution(m, times));
  const Certifier blocks(m);
  PathProof path(m, blocks);
  EXPECT_EQ(first_knot(m, 0.98, 1.02), 1);
  EXPECT_FALSE(first_knot(m, 1, 1.02));
  EXPECT_FALSE(path.prove(at[0].view(), at[2].view()).proven);
  for (const std::size_t from : {0, 1, 2, 4})
    EXPECT_TRUE(path.prove(at[from].view(), at[from + 1].view()).proven);
}

}  // namespace
}  // namespace desmo::path_proof_test
