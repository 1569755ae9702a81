// Conditioning against matrices inverted by hand, and as a prediction of what double can reach.

#include "formulations/verification/condition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "formulations/constraints/constraints.h"
#include "formulations/variants.h"
#include "formulations/verification/error.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"

namespace desmo::condition_test {
namespace {

/// Two links of length 1 from (0, 0) and (2 cos α, 0) that meet in C = (cos α, sin α).
struct Dyad {
  Model m;
  std::vector<double> q;

  explicit Dyad(double alpha) : q{std::cos(alpha), std::sin(alpha)} {
    const GroupId g = m.add_group("dyad", {"left", "right"});
    const EntityId a = m.add_fixed(EntityKind::point, "A", std::array{0.0, 0.0});
    const EntityId b = m.add_fixed(EntityKind::point, "B", std::array{2 * q[0], 0.0});
    const EntityId c = m.add(EntityKind::point, "C", q, g);
    m.add({"left", kind_index<Length<2>>(), {a, c}, {1}, g});
    m.add({"right", kind_index<Length<2>>(), {b, c}, {1}, g});
  }
};

TEST(Condition, IsThatOfADyadByHand) {
  for (const double alpha : {1.5, 0.8, 0.1, 1e-3, 1e-6}) {
    const Dyad d(alpha);
    const double x = std::cos(alpha), y = std::sin(alpha), sum = x + y;
    // A = ((x, y), (−x, y)) / sum, A⁻¹ = ((y, −y), (x, x)) sum / (2 x y)
    const double expected = sum / std::min(x, y);
    EXPECT_NEAR(ConditionNumber(d.m)(d.q) / expected, 1, 1e-9) << alpha;
  }
}

TEST(Condition, OfASingularPositionIsInfiniteOrBeyondDouble) {
  const Dyad d(0);
  EXPECT_GT(ConditionNumber(d.m)(d.q), 1e15);
}

/// The inverse has rows with a difference of infinite numbers, and finite ones after these.
TEST(Condition, IsInfiniteWhereTheInverseOverflows) {
  constexpr double tiny = 1e-310;
  constexpr int pair = kind_index<Coupling<2>>(), three = kind_index<Coupling<3>>();
  Model m;
  const GroupId g = m.add_group("angles", {});
  const EntityId fixed = m.add_fixed(EntityKind::angle, "fixed", std::array{0.0});
  std::vector<EntityId> x;
  for (const char* name : {"x0", "x1", "x2", "x3", "x4"})
    x.push_back(m.add(EntityKind::angle, name, std::array{0.0}, g));
  m.add({"first", pair, {x[0], fixed}, {1, 1, 0}, g});
  m.add({"second", pair, {x[0], x[1]}, {1, tiny, 0}, g});
  m.add({"third", pair, {x[0], x[2]}, {1, tiny, 0}, g});
  m.add({"fourth", three, {x[1], x[2], x[3]}, {1, -1, 1, 0}, g});
  m.add({"last", pair, {x[4], fixed}, {1, 1, 0}, g});
  EXPECT_EQ(ConditionNumber(m)(m.estimate), INFINITY);
}

TEST(Condition, DoesNotDependOnUnits) {
  double condition[2];
  for (int unit = 0; unit < 2; ++unit) {
    const Model m = make_model(enlarged(library_scene("stewart"), unit == 0 ? 1 : 1e6));
    const auto r = reference_solution(m, std::vector{0.1}, Precision::standard);
    condition[unit] = ConditionNumber(m)(r[0].q);
  }
  EXPECT_GT(condition[0], 1);
  EXPECT_NEAR(condition[1] / condition[0], 1, 1e-9);
}

TEST(Condition, LimitGrowsWithTheLevel) {
  const PerLevel<double> limit = accuracy_limit(100, 1e-16);
  EXPECT_DOUBLE_EQ(limit.position, 1e-14);
  EXPECT_DOUBLE_EQ(limit.velocity, 1e-12);
  EXPECT_DOUBLE_EQ(limit.acceleration, 1e-10);
}

TEST(Condition, PredictsWhatDoubleReaches) {
  for (const Scene& scene : library_scenes()) {
    const Model m = make_model(scene);
    const TimeGrid grid = tested(scene.grid);
    const Reference r = make_reference(m, sampled(grid, DESMO_SANITIZED ? 3 : 9));
    ErrorMeasure measure(m, r.instants, r.scales);
    const auto f =
        make_formulation(find_variant("global_automatic_klu"), m, {.fixed_iterations = 12});
    const Summary s = f->run(grid, {}, measure);
    ASSERT_TRUE(s.ok()) << describe(s, m);
    double condition = 0;
    ConditionNumber condition_number(m);
    for (const ReferenceInstant& at : r.instants)
      condition = std::max(condition, condition_number(at.q));
    const PerLevel<double> limit = accuracy_limit(condition, 0x1p-53);
    const SolutionError e = measure.error();
    for (const Level level : all_levels) EXPECT_LT(e[level].max, 100 * limit[level]) << m.name;
  }
}

}  // namespace
}  // namespace desmo::condition_test
