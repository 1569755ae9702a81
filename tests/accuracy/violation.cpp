// Constraint violation at each level, apart from the error.

#include "formulations/verification/violation.h"

#include <gtest/gtest.h>

#include "formulations/variants.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"

namespace desmo::violation_test {
namespace {

struct Violated {
  explicit Violated(double factor)
      : scene(enlarged(library_scene("stewart"), factor)),
        m(make_model(scene)),
        times(sampled(scene.grid, 5)),
        reference(make_reference(m, times)) {}

  SolutionError of(const std::vector<ReferenceInstant>& instants) const {
    ViolationMeasure measure(m, reference.scales, times);
    for (const ReferenceInstant& r : instants) measure.observe({0, r.time, r.q, r.qd, r.qdd});
    return measure.violation();
  }

  Scene scene;
  Model m;
  std::vector<double> times;
  Reference reference;
};

TEST(Violation, OfTheReferenceIsThatOfRounding) {
  const Violated v(1);
  const SolutionError e = v.of(v.reference.instants);
  EXPECT_EQ(e.instants, 5);
  EXPECT_EQ(e.position.compared, 5L * (v.m.coordinates() - v.m.degrees_of_freedom()));
  for (const Level level : levels) {
    EXPECT_GT(e[level].max, 1e-19);
    EXPECT_LT(e[level].max, 4e-16);
    EXPECT_LE(e[level].rms, e[level].max);
  }
}

TEST(Violation, StartsAtTheLevelThatIsWrong) {
  const Violated v(1);
  for (const Level wrong : levels) {
    std::vector<ReferenceInstant> instants = v.reference.instants;
    ReferenceInstant& r = instants[2];
    std::vector<double>& values = wrong == Level::position   ? r.q
                                  : wrong == Level::velocity ? r.qd
                                                             : r.qdd;
    int changed = 0;  // the first coordinate of a point
    while (v.m.entities[changed].kind != EntityKind::point || v.m.entities[changed].fixed)
      ++changed;
    values[v.m.entities[changed].first] += 1e-6 * v.reference.scales.length[wrong];
    const SolutionError e = v.of(instants);
    for (const Level level : levels) {
      if (level < wrong) {
        EXPECT_LT(e[level].max, 4e-16);
      } else if (level == wrong) {
        EXPECT_GT(e[level].max, 1e-8);
        EXPECT_LT(e[level].max, 1.1e-6);
      }
    }
  }
}

TEST(Violation, IsTheSameInMetresAndMillimetres) {
  SolutionError errors[2];
  for (int unit = 0; unit < 2; ++unit) {
    const double factor = unit == 0 ? 1 : 1000;
    const Violated v(factor);
    std::vector<ReferenceInstant> instants = v.reference.instants;
    for (ReferenceInstant& r : instants)
      for (const Entity& e : v.m.entities)
        for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
          for (std::vector<double>* values : {&r.q, &r.qd, &r.qdd})
            (*values)[i] += 1e-5 * std::sin(i) * (is_length(e.kind) ? factor : 1);
    errors[unit] = v.of(instants);
  }
  for (const Level level : levels)
    EXPECT_NEAR(errors[1][level].max / errors[0][level].max, 1, 1e-9);
}

TEST(Violation, OfAFormulationIsWithinItsTolerance) {
  const Violated v(1);
  for (const double tolerance : {1e-3, 1e-8}) {
    ViolationMeasure measure(v.m, v.reference.scales, v.times);
    const auto f =
        make_formulation(find_variant("global_automatic_klu"), v.m, {.tolerance = tolerance});
    const Summary s = f->run(v.scene.grid, {}, measure);
    ASSERT_TRUE(s.ok()) << describe(s, v.m);
    EXPECT_EQ(measure.violation().instants, 5);
    EXPECT_LT(measure.violation().position.max, tolerance);
    EXPECT_LT(measure.violation().acceleration.max, 1e-13);  // solved exactly, for that position
  }
}

}  // namespace
}  // namespace desmo::violation_test
