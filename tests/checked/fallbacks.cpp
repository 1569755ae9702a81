// What generated code leaves to pivoting: nothing where a motion stays far from singular positions.

#include <gtest/gtest.h>

#include <algorithm>

#include "formulations/motion/internals.h"
#include "formulations/variants.h"
#include "tests/accuracy/scenes.h"
#include "tests/checked/rows.h"
#include "tests/discard.h"

namespace desmo::fallbacks_test {
namespace {

TEST(GeneratedCode, LeavesNoStepOfAWellConditionedMotionToPivoting) {
  constexpr double well = 1e4;
  int motions = 0;
  for (const Scene& scene : library_scenes()) {
    const Model m = make_model(scene);
    if (solve_checked(m, scene.grid, "global_automatic_klu").summary.condition >= well) continue;
    ++motions;
    for (const Variant& v : variants()) {
      if (!v.is_generated()) continue;
      const auto f = make_formulation(v, m, {.tolerance = scene.tolerance});
      Discard observer;
      EXPECT_TRUE(f->run(scene.grid, {}, observer).ok()) << m.name << ", " << v.id;
      EXPECT_TRUE(std::ranges::any_of(parts_of(*f), &DefinedPart::as_named)) << m.name;
      EXPECT_EQ(part_counts(*f).fallbacks, 0) << m.name << ", " << v.id;
    }
  }
  EXPECT_GE(motions, 10);
}

}  // namespace
}  // namespace desmo::fallbacks_test
