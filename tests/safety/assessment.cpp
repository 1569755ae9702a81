// What is said of a solved instant, against the quadruple reference: never less than its error, and
// not much more than conditioning explains.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "formulations/variants.h"
#include "formulations/verification/assessment/assessor.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/error.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/dead_point.h"

namespace desmo::assessment_test {
namespace {

/// Compares each instant that a reference has with what is said of it.
class Comparison final : public Observer {
 public:
  Comparison(const Model& m, const Reference& reference, bool corrected)
      : m_(m), reference_(reference), assessor_(m), condition_(m), corrected_(corrected) {}

  Flow observe(const Instant& given) noexcept override {
    if (next_ == reference_.instants.size() || given.time != reference_.instants[next_].time)
      return Flow::go_on;
    const Instant instant = corrected_ ? assessor_.corrected(given) : given;
    const Assessment a = assessor_(instant, reference_.scales);
    ErrorMeasure measure(m_, std::span(reference_.instants).subspan(next_, 1), reference_.scales);
    measure.observe(instant);
    const double condition = condition_(reference_.instants[next_].q);
    EXPECT_LT(a.condition, 10 * condition) << instant.time;
    EXPECT_GT(a.condition, condition / 10) << instant.time;
    const PerLevel<double> floor = accuracy_limit(condition, 0x1p-53);
    for (const Level level : all_levels) {
      const double error = measure.error()[level].max;
      EXPECT_LE(error, a.bound[level]) << m_.name << ", " << instant.time << " s";
      if (corrected_ && !a.singular) {
        EXPECT_LE(a.bound[level], 1000 * floor[level]) << m_.name << ", " << instant.time << " s";
      }
    }
    singular_ += a.singular;
    ++next_;
    return Flow::go_on;
  }
  std::size_t compared() const { return next_; }
  int singular() const { return singular_; }

 private:
  const Model& m_;
  const Reference& reference_;
  Assessor assessor_;
  ConditionNumber condition_;
  bool corrected_;
  std::size_t next_ = 0;
  int singular_ = 0;
};

constexpr const char* ids[] = {"global_automatic_klu", "group_symbolic_inlined",
                               "group_symbolic_explicit"};

TEST(Assessment, IsNeverLessThanTheErrorOfLibraryMotions) {
  for (const LibraryMechanism& l : library()) {
    const Scene scene = library_scene(l.name);
    const Model m = make_model(scene);
    const Reference reference = make_reference(m, sampled(scene.grid, 9));
    for (const char* id : ids)
      for (const bool corrected : {false, true}) {
        SCOPED_TRACE(id);
        Comparison comparison(m, reference, corrected);
        ASSERT_TRUE(make_formulation(find_variant(id), m)->run(scene.grid, {}, comparison).ok());
        EXPECT_EQ(comparison.compared(), reference.instants.size());
        EXPECT_EQ(comparison.singular(), 0) << l.name;
      }
  }
}

TEST(Assessment, IsNeverLessThanTheErrorNearADeadPoint) {
  for (double distance = 1e-2; distance > 0.9e-13; distance /= 10) {
    const Model m = locking_four_bar(Polynomial{{dead_point - distance, -1}});
    const TimeGrid grid{0, distance / 64, 9};
    const Reference reference = make_reference(m, sampled(grid, 9));
    for (const char* id : ids)
      for (const bool corrected : {false, true}) {
        SCOPED_TRACE(std::string(id) + ", " + std::to_string(std::log10(distance)));
        Comparison comparison(m, reference, corrected);
        ASSERT_TRUE(make_formulation(find_variant(id), m)->run(grid, {}, comparison).ok());
        EXPECT_EQ(comparison.compared(), 9u);
        if (corrected) {
          EXPECT_EQ(comparison.singular(), 0);
        }
      }
  }
}

/// Coupler and rocker in line, where the pin's velocity is whatever one likes.
TEST(Assessment, CallsADeadPointSingular) {
  for (const double distance : {0.0, 1e-15, 1e-14}) {
    const Model m = locking_four_bar(Polynomial{{dead_point - distance, 1}});
    Assessor assessor(m);
    const std::vector<double> rates(m.coordinates(), 1);
    const Assessment a = assessor({0, 0, m.estimate, rates, rates}, {});
    EXPECT_TRUE(a.singular) << distance;
    ASSERT_GE(a.group, 0);
    EXPECT_EQ(m.groups[a.group].name, "dyad1/SG-I");
    for (const Level level : all_levels) EXPECT_EQ(a.bound[level], INFINITY);
  }
}

/// The signs tell a dyad from its mirror image, whatever the pivots were.
TEST(Assessment, OrientationIsTheBranchOfADyad) {
  const Model above = locking_four_bar(Polynomial{{dead_point - 0.5, 1}});
  Model below = above;
  // Mirrored at the line from B to D.
  const auto at = [&](const char* name) { return below.entities[below.find(name)].first; };
  const double bx = below.estimate[at("crank/B")], by = below.estimate[at("crank/B") + 1];
  double& cx = below.estimate[at("dyad1/C")];
  double& cy = below.estimate[at("dyad1/C") + 1];
  const double ex = 8 - bx, ey = -by;
  const double along = ((cx - bx) * ex + (cy - by) * ey) / (ex * ex + ey * ey);
  cx = 2 * (bx + along * ex) - cx;
  cy = 2 * (by + along * ey) - cy;
  below.estimate[at("dyad1/psi")] = std::atan2(cy, cx - 8);

  Assessor assessor(above);
  std::vector<signed char> signs[2];
  for (const Model* m : std::array<const Model*, 4>{&above, &below, &above, &below}) {
    ASSERT_TRUE(!assessor({0, 0, m->estimate, {}, {}}, {}).singular);
    const auto now = assessor.system().orientation();
    std::vector<signed char>& known = signs[m == &below];
    if (known.empty()) known.assign(now.begin(), now.end());
    EXPECT_TRUE(std::ranges::equal(now, known));
  }
  EXPECT_NE(signs[0], signs[1]);
}

}  // namespace
}  // namespace desmo::assessment_test
