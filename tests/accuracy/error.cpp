// What the error measure says of errors that are known.

#include "formulations/verification/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formulations/variants.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"

namespace desmo::error_test {
namespace {

class SliderCrank : public testing::Test {
 protected:
  static const Model& model() {
    static const Model m = make_model(library_scene("slider_crank"));
    return m;
  }
  static const Reference& reference() {
    static const Reference r = make_reference(model(), std::vector{0.0, 0.2, 0.5, 0.9});
    return r;
  }
  static int first(const std::string& name) { return model().entities[model().find(name)].first; }
  static int outputs() {
    int moving = 0;
    for (const Entity& e : model().entities) moving += !e.fixed;
    return moving;
  }
  /// Returns the error of instants of which each is compared with the reference at its time.
  static SolutionError error_of(std::span<const ReferenceInstant> found,
                                ErrorMeasure measure = {model(), reference().instants,
                                                        reference().scales}) {
    for (const ReferenceInstant& r : found) measure.observe({0, r.time, r.q, r.qd, r.qdd});
    return measure.error();
  }
};

TEST_F(SliderCrank, ScalesAreThoseOfTheMotion) {
  const Scales& s = reference().scales;
  EXPECT_DOUBLE_EQ(s.length.position, 0.2);  // from the crank's pivot to the outer dead point
  const double w = 2 * 3.14159265358979323846;
  EXPECT_NEAR(s.length.velocity, 0.05 * w, 0.02);  // of B, and of C somewhat more
  EXPECT_NEAR(s.length.acceleration, 0.05 * w * w * (1 + 0.05 / 0.15), 1e-12);  // of C, outermost
  EXPECT_EQ(s.rotation.position, 1);
  EXPECT_NEAR(s.rotation.velocity, w, 1e-12);  // of the crank
  EXPECT_GT(s.rotation.acceleration, 0);       // of the rod
}

TEST_F(SliderCrank, SaysMaximumAndRmsOfAKnownError) {
  const Scales& scales = reference().scales;
  std::vector<ReferenceInstant> wrong = reference().instants;
  wrong[2].q[first("B")] += 3e-6 * scales.length.position;
  wrong[2].q[first("B") + 1] += 4e-6 * scales.length.position;
  wrong[1].q[first("phi")] -= 1e-6;
  wrong[0].qd[first("s")] += 1e-5 * scales.length.velocity;
  wrong[3].qdd[first("phi")] += 1e-4 * scales.rotation.acceleration;

  const SolutionError e = error_of(wrong);
  EXPECT_EQ(e.instants, 4);
  const double n = 4.0 * outputs();
  EXPECT_EQ(e.position.compared, 4 * outputs());
  EXPECT_NEAR(e.position.max, 5e-6, 1e-14);
  EXPECT_NEAR(e.position.rms, std::sqrt((25 + 1) / n) * 1e-6, 1e-14);
  EXPECT_NEAR(e.velocity.max, 1e-5, 1e-14);
  EXPECT_NEAR(e.velocity.rms, 1e-5 / std::sqrt(n), 1e-14);
  EXPECT_NEAR(e.acceleration.max, 1e-4, 1e-14);
  EXPECT_NEAR(e.acceleration.rms, 1e-4 / std::sqrt(n), 1e-14);
}

TEST_F(SliderCrank, ResolvesWhatRoundingToDoubleLoses) {
  double expected = 0;
  for (const ReferenceInstant& r : reference().instants)
    expected = std::max(expected, std::abs(r.remainder.q[first("phi")]));
  EXPECT_GT(expected, 0);
  const SolutionError e = error_of(reference().instants);
  EXPECT_GE(e.position.max, expected);
  EXPECT_LT(e.position.max, 4.5e-16);  // half an ulp of θ, of up to 2 π
  EXPECT_GT(e.velocity.max, 0);
  EXPECT_LT(e.velocity.max, 2e-16);
}

TEST_F(SliderCrank, CountsAWholeTurnAsAnError) {
  std::vector<ReferenceInstant> wrong = reference().instants;
  wrong[1].q[first("phi")] += 2 * 3.14159265358979323846;
  EXPECT_NEAR(error_of(wrong).position.max, 6.283, 1e-3);
}

TEST_F(SliderCrank, NotANumberIsInfinitelyWrong) {
  std::vector<ReferenceInstant> wrong = reference().instants;
  wrong[0].qd[first("s")] = std::numeric_limits<double>::quiet_NaN();
  const SolutionError e = error_of(wrong);
  EXPECT_LT(e.position.max, 1e-15);
  EXPECT_EQ(e.velocity.max, INFINITY);
  EXPECT_EQ(e.velocity.rms, INFINITY);
}

TEST_F(SliderCrank, ComparesOnlyWhatIsAskedAndDelivered) {
  std::vector<ReferenceInstant> wrong = reference().instants;
  for (ReferenceInstant& r : wrong) {
    r.q[first("phi")] += 1;
    r.qd[first("s")] += 1;
  }
  const std::vector<Output> asked{{model().find("s"), Level::position},
                                  {model().find("A"), Level::acceleration}};  // A is fixed
  const SolutionError e =
      error_of(wrong, {model(), reference().instants, reference().scales, asked});
  EXPECT_EQ(e.position.compared, 4);
  EXPECT_LT(e.position.max, 1e-15);
  EXPECT_EQ(e.velocity.compared, 0);

  const ReferenceInstant& r = reference().instants[0];
  const ReferenceInstant positions{r.time, r.q, {}, {}};
  EXPECT_EQ(error_of({&positions, 1}).position.compared, outputs());
  EXPECT_EQ(error_of({&positions, 1}).velocity.compared, 0);
}

TEST_F(SliderCrank, SkipsInstantsThatTheReferenceHasNot) {
  ErrorMeasure measure(model(), reference().instants, reference().scales);
  const auto f =
      make_formulation(find_variant("global_automatic_klu"), model(), {.tolerance = 1e-13});
  const TimeGrid grid{0, 0.05, 21};
  const Summary s = f->run(grid, {}, measure);
  ASSERT_TRUE(s.ok()) << describe(s, model());
  int common = 0;  // instants of the grid that are, to the last bit, instants of the reference
  for (int i = 0; i < grid.instants; ++i)
    for (const ReferenceInstant& r : reference().instants) common += r.time == grid.time(i);
  EXPECT_GE(common, 3);
  EXPECT_EQ(measure.error().instants, common);
  EXPECT_LT(measure.error().acceleration.max, 1e-12);
}

TEST(ErrorMeasure, IsTheSameInMetresAndMillimetres) {
  SolutionError errors[2];
  for (int unit = 0; unit < 2; ++unit) {
    const double factor = unit == 0 ? 1 : 1000;
    const Scene scene = enlarged(library_scene("double_wishbone"), factor);
    const Model m = make_model(scene);
    const Reference r = make_reference(m, sampled(scene.grid, 5));
    ErrorMeasure measure(m, r.instants, r.scales);
    for (const ReferenceInstant& at : r.instants) {
      std::vector<double> q = at.q, qd = at.qd, qdd = at.qdd;
      for (const Entity& e : m.entities)
        for (int i = e.first; !e.fixed && i < e.first + e.size; ++i) {
          const double wrong = std::sin(i + at.time) * (is_length(e.kind) ? factor : 1);
          q[i] += 1e-3 * wrong;
          qd[i] += 1e-4 * wrong;
          qdd[i] += 1e-5 * wrong;
        }
      measure.observe({0, at.time, q, qd, qdd});
    }
    errors[unit] = measure.error();
  }
  for (const Level level : all_levels) {
    EXPECT_GT(errors[0][level].max, 1e-8);
    EXPECT_NEAR(errors[1][level].max / errors[0][level].max, 1, 1e-9);
    EXPECT_NEAR(errors[1][level].rms / errors[0][level].rms, 1, 1e-9);
  }
}

TEST(Scales, WhatDoesNotMoveIsJudgedByWhatDoes) {
  Model m;
  const GroupId g = m.add_group("g", {"body"});
  m.add(EntityKind::point, "P", std::array{3.0, 4.0}, g);
  m.add_fixed(EntityKind::point, "O", std::array{0.0, 0.0});
  m.add(EntityKind::angle, "still", std::array{1.0}, g);
  EXPECT_EQ(nominal_size(m), 5);
  EXPECT_EQ(nominal_magnitudes(m), (std::vector<double>{5, 5, 1}));
  const ReferenceInstant uniform{0, {3, 4, 1}, {6, 8, 1e-40}, {0, 0, 0}};
  const Scales s = make_scales(m, std::span(&uniform, 1));
  EXPECT_EQ(s.length.velocity, 10);
  EXPECT_EQ(s.rotation.velocity, 2);      // 10 / 5
  EXPECT_EQ(s.length.acceleration, 20);   // 10² / 5
  EXPECT_EQ(s.rotation.acceleration, 4);  // 2²
  EXPECT_EQ(relative(0, 0), 0);
  EXPECT_EQ(relative(1e-30, 0), INFINITY);
}

}  // namespace
}  // namespace desmo::error_test
