// What generated code leaves to pivoting: nothing where a motion stays far from singular positions.

#include <gtest/gtest.h>

#include <algorithm>

#include "cases/library/library.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/structure/partition.h"
#include "formulations/variants.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "tests/discard.h"
#include "tests/mechanisms.h"

namespace desmo::fallbacks_test {
namespace {

/// Returns the largest condition number of a motion, of which every instant is assessed.
double condition(const Model& m, const TimeGrid& grid) {
  Discard observer;
  MonitoredRunOptions options;
  options.assesses_all = true;
  return run_monitored(*make_formulation(find_variant("global_automatic_klu"), m), grid, {},
                       observer, options)
      .condition;
}

/// Returns how many steps the parts of a motion left to pivoting.
long fallbacks(const Variant& v, const Model& m, const Scene& scene) {
  const auto f = make_formulation(v, m, {.tolerance = scene.tolerance});
  Discard observer;
  const Summary s = f->run(scene.grid, {}, observer);
  EXPECT_TRUE(s.ok()) << m.name << ", " << v.id;
  EXPECT_TRUE(std::ranges::any_of(parts_of(*f), &DefinedPart::as_named))
      << m.name << ", " << v.id << ": there is no generated code";
  return part_counts(*f).fallbacks;
}

TEST(GeneratedCode, LeavesNoStepOfAWellConditionedMotionToPivoting) {
  constexpr double well = 1e4;
  int motions = 0;
  for (const LibraryMechanism& l : library()) {
    const Scene scene = library_scene(l.name);
    const Model m = make_model(scene);
    if (condition(m, scene.grid) >= well) continue;
    ++motions;
    for (const Variant& v : variants()) {
      if (!v.is_generated()) continue;
      EXPECT_EQ(fallbacks(v, m, scene), 0) << l.name << ", " << v.id;
    }
  }
  EXPECT_GE(motions, 10);
}

}  // namespace
}  // namespace desmo::fallbacks_test
