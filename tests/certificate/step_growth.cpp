// When a path tries longer steps.

#include "formulations/verification/branch/step_growth.h"

#include <gtest/gtest.h>

namespace desmo::growth_test {
namespace {

/// Expects that `steps` steps succeed before the next one is to be longer.
void expect_wait(StepGrowth& growth, int steps) {
  for (int i = 0; i < steps; ++i) EXPECT_FALSE(growth.succeeded()) << i << " of " << steps;
  EXPECT_TRUE(growth.succeeded()) << steps;
}

TEST(StepGrowth, WaitsTwiceAsLongAfterEachLongerStepThatFails) {
  StepGrowth growth;
  expect_wait(growth, 0);
  for (int wait = 2; wait < 2000; wait *= 2) {
    growth.failed();
    expect_wait(growth, wait);
  }
  expect_wait(growth, 0);  // a longer one was good
  for (int i = 0; i < 5; ++i) growth.failed();
  expect_wait(growth, 2);  // the first of the five was longer
}

}  // namespace
}  // namespace desmo::growth_test
