// Every formulation of the table, on every case and size, against the quadruple reference.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/every_variant.h"
#include "tests/everything.h"
#include "tests/named_difference.h"

namespace desmo::formulations_test {
namespace {

constexpr double short_motion = DESMO_SANITIZED ? 0.05 : 0.5;  // s

/// A motion of a case, and its reference at up to 51 instants.
class Motion {
 public:
  Motion(const Case& definition, int coordinates, double seconds)
      : model(make_model(make_scene(definition, coordinates))),
        grid(time_grid(seconds, seconds > 6 ? 0.02 : 0.01)) {
    Reference made = make_reference(model, sampled(grid, std::min(51, grid.instants)));
    for (const Level level : all_levels) EXPECT_LT(made.floor[level], 1e-20) << model.name;
    reference = std::move(made.instants);
  }

  const Model model;
  const TimeGrid grid;
  std::vector<ReferenceInstant> reference;
};

void expect_agreement(const Variant& v, const Motion& motion) {
  const std::string where = v.id + " on " + motion.model.name;
  NamedDifference difference(motion.model, motion.model, motion.reference);
  const Summary s = make_formulation(v, motion.model)->run(motion.grid, {}, difference);
  EXPECT_TRUE(s.ok()) << where << ": " << describe(s, motion.model);
  difference.expect_agreement(where);
  EXPECT_LT(s.residual, 1e-10) << where;
}

/// References are expensive: all formulations of one case and size share one test and one.
class Sizes : public testing::TestWithParam<std::pair<const Case*, int>> {};

/// Every formulation solves the whole motion at the smallest size and a part of it at the others,
/// where dense global solves take long.
TEST_P(Sizes, EveryFormulationAgreesWithTheQuadrupleReference) {
  const auto [definition, coordinates] = GetParam();
  const bool smallest = coordinates == definition->sizes.front();
  const Motion motion(*definition, coordinates, smallest ? DESMO_TEST_SECONDS : short_motion);
  for (const Variant& v : tested_variants()) expect_agreement(v, motion);
}

/// All sizes; with sanitizers the two smallest, as more of the same finds no other error of memory.
std::vector<std::pair<const Case*, int>> tested_sizes() {
  std::vector<std::pair<const Case*, int>> result;
  for (const Case& c : cases())
    for (std::size_t i = 0; i < (DESMO_SANITIZED ? 2 : c.sizes.size()); ++i)
      result.emplace_back(&c, c.sizes[i]);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Cases, Sizes, testing::ValuesIn(tested_sizes()), [](const auto& info) {
  return std::string(info.param.first->name) + "_" + std::to_string(info.param.second);
});

class LargestSizes : public testing::TestWithParam<const Case*> {};

/// The paper's reference and the fastest formulation stand for all over a longer motion.
TEST_P(LargestSizes, TwoFormulationsAgreeOverALongerMotion) {
  const Case& definition = *GetParam();
  const double duration = DESMO_SANITIZED ? short_motion : 6;
  const Motion motion(definition, definition.sizes.back(), duration);
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"})
    expect_agreement(find_variant(id), motion);
}

INSTANTIATE_TEST_SUITE_P(Cases, LargestSizes,
                         testing::Values(&find_case("four_bar"), &find_case("truck_suspension")),
                         [](const auto& info) { return std::string(info.param->name); });

EVERY_VARIANT(EveryFormulation);

TEST_P(EveryFormulation, RepeatsARunToTheLastBit) {
  const Model m = truck_model(1);
  const auto f = make_formulation(GetParam(), m);
  Everything first(51), second(51);
  // Pivots chosen in the first run may serve the second; the third starts like the second.
  const TimeGrid grid = time_grid(0.5, 0.01);
  ASSERT_TRUE(f->run(grid, {}, first).ok());
  ASSERT_TRUE(f->run(grid, {}, first).ok());
  ASSERT_TRUE(f->run(grid, {}, second).ok());
  EXPECT_EQ(first.all, second.all);
}

TEST_P(EveryFormulation, TakesAFixedNumberOfIterationsWhereAsked) {
  const Model m = truck_model(1);
  const auto usual = make_formulation(GetParam(), m);
  const auto fixed = make_formulation(GetParam(), m, {.fixed_iterations = 4});
  for (int i = 0; i < 10; ++i) {
    const double t = 0.01 * i;
    ASSERT_TRUE(usual->step(t).ok());
    const Summary s = fixed->step(t);
    ASSERT_TRUE(s.ok()) << describe(s, m);
    EXPECT_EQ(s.iterations, 4) << t;
  }
  EXPECT_LT(fixed->step(0.09).residual, Settings{}.tolerance);
  EXPECT_LT(max_difference(fixed->q(), usual->q()), 1e-9);
}

}  // namespace
}  // namespace desmo::formulations_test
