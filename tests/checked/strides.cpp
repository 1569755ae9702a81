// The stride of a run that goes on from its last row: halved where an instant cannot be solved.

#include <gtest/gtest.h>

#include "formulations/verification/run/strided_steps.h"

namespace desmo::strides_test {
namespace {

TEST(StrideControl, HalvesAtOnceAndDoublesWithPatience) {
  StrideControl stride(7);
  stride.halve();
  EXPECT_EQ(stride.now(), 3);
  const auto keep = [&](int intervals) {
    for (int i = 0; i < intervals; ++i) stride.keep();
    return stride.now();
  };
  EXPECT_EQ(keep(1), 6);
  for (int wait = 2; wait < 2000; wait *= 2) {
    stride.halve();  // that was too early
    EXPECT_EQ(stride.now(), 3);
    EXPECT_EQ(keep(wait), 3);
    EXPECT_EQ(keep(1), 6);
  }
  EXPECT_EQ(keep(1), 7);  // a long one was good
  EXPECT_EQ(keep(1000), 7);
  for (int i = 0; i < 5; ++i) stride.halve();
  EXPECT_EQ(stride.now(), 1);
  EXPECT_EQ(keep(2), 1);  // a long one was good for long: this was the first one that failed
  EXPECT_EQ(keep(1), 2);
}

}  // namespace
}  // namespace desmo::strides_test
