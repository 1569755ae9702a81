// Passes of refinement: as many as are seen in the last digits, and no more.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/certificate/refinement.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/containment.h"
#include "tests/certificate/turned_chain.h"
#include "tests/dead_point.h"

namespace desmo::refinement_passes_test {
namespace {

constexpr double u = 0x1p-53;

double largest(std::span<const double> radii) { return std::ranges::max(radii); }

/// Boxes grow from group to group of a long chain at one of these positions.
TEST(Refinement, TakesBasesWhereBoxesGrow) {
  const Model m = make_model(turned_chain(185));
  Certifier certifier(m);
  Refinement refinement(m);
  for (const ReferenceInstant& s : double_solution(m, std::array{0.0, 1.5, 2.0})) {
    const RefinedInstant& refined = refinement.refine(instant_of(s));
    EXPECT_TRUE(refined.proven);
    EXPECT_LE(refined.passes, 3);
    const Certificate boxes = certifier.certify(instant_of(s));
    EXPECT_EQ(largest(boxes.radius.acceleration) > 1e-4, s.time == 1.5);
    for (const Level level : all_levels) EXPECT_LE(largest(refined.radius[level]), 1e-12) << s.time;
  }
}

/// Another pass, or bases, would cost as much again, and take nothing off.
TEST(Refinement, TakesOnePassAlongAChainWhereBoxesDo) {
  const Scene scene = make_scene(find_case("four_bar"), 558);
  const Model m = make_model(scene);
  Refinement refinement(m);
  for (const ReferenceInstant& s : double_solution(m, std::array{0.5, 1.0}))
    EXPECT_EQ(refinement.refine(instant_of(s)).passes, 1);
}

/// The first pass leaves 4 roundings of the first instant, which a second one takes off; the second
/// leaves half a rounding of the next, which may stay. The third is so near a dead point that each
/// pass leaves 3: what the second would take off is a tenth of a rounding.
TEST(Refinement, TakesThePassesThatAreSeen) {
  struct Start {
    double from_dead_point, off;
    int passes;
  };
  for (const auto& [distance, off, passes] :
       {Start{1, 7e-9, 2}, Start{1, 4.4e-5, 2}, Start{1e-4, 3e-11, 1}}) {
    const Model m = locking_four_bar(Polynomial{{dead_point - distance, 1}});
    const ReferenceInstant s = double_solution(m, std::array{0.0}).front();
    Refinement refinement(m);
    const double best = largest(refinement.refine(instant_of(s)).radius.acceleration);
    const ReferenceInstant start = moved(m, s, off);
    const RefinedInstant& r = refinement.refine(instant_of(start));
    EXPECT_EQ(r.passes, passes) << off;
    double size = 0;
    for (const double x : s.qdd) size = std::max(size, std::abs(x));
    EXPECT_LE(largest(r.radius.acceleration), 2 * best + size * u) << off;
  }
}

/// From afar, passes leave up to 1/2000 of errors that are still large. Next to a dead point a pass
/// that leaves 1/100 of them has come down to rounding.
TEST(Refinement, TakesPassesWhileNewtonsMethodConverges) {
  const Scene scene = library_scene("double_wishbone");
  const Model far = make_model(scene);
  const ReferenceInstant start = double_solution(far, std::span(&scene.grid.start, 1)).front();
  const ReferenceInstant from = moved(far, start, 0.0237);
  Refinement refinement(far);
  const RefinedInstant& r = refinement.refine(instant_of(from));
  for (const Level level : all_levels) EXPECT_LE(largest(r.radius[level]), 1e-15);

  const Model near = locking_four_bar(Polynomial{{dead_point - 1e-12, 1}});
  const ReferenceInstant s = double_solution(near, std::array{0.0}).front();
  EXPECT_LE(Refinement(near).refine(instant_of(s)).passes, 2);
}

TEST(Refinement, LeavesWhatItCannotProve) {
  const Model m = locking_four_bar(Polynomial{{dead_point}});
  const std::vector<double> zero(m.coordinates());
  Refinement refinement(m);
  const RefinedInstant& r =
      refinement.refine({.index = 3, .time = 0, .q = m.estimate, .qd = zero, .qdd = zero});
  EXPECT_FALSE(r.proven);
  EXPECT_LE(r.passes, 16);  // each costs as much as a proven instant
  EXPECT_EQ(r.instant.q.data(), m.estimate.data());
  EXPECT_EQ(r.instant.index, 3);
}

}  // namespace
}  // namespace desmo::refinement_passes_test
