// A motion that is entered in its middle, from a position of another instant.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formulations/motion/internals.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::continued_start_test {
namespace {

constexpr double entered = 0.5, later = 1.5;  // s

struct ContinuedStart : testing::TestWithParam<const char*> {
  Model model = four_bar_model(3);

  /// Positions after so many steps of 10 ms.
  std::vector<double> stepped(int steps) {
    const auto f = formulated(GetParam(), model);
    EXPECT_TRUE(f->assemble(0).ok());
    for (int i = 1; i <= steps; ++i) EXPECT_TRUE(f->step(0.01 * i).ok());
    return {f->q().begin(), f->q().end()};
  }
};

/// So far away one try is not enough, with so few iterations.
TEST_P(ContinuedStart, IsGoneOnFromInSubSteps) {
  const auto f = formulated(GetParam(), model, {.max_iterations = 3});
  ASSERT_TRUE(stepping_of(*f).start_at(stepped(0), entered));
  const Summary step = f->step(later);
  ASSERT_TRUE(step.ok());
  EXPECT_GT(step.sub_steps, 0);
  EXPECT_LT(max_difference(f->q(), stepped(150)), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Formulations, ContinuedStart,
                         testing::Values("global_automatic_klu", "group_automatic_lapack",
                                         "group_symbolic_inlined"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace desmo::continued_start_test
