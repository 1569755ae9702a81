// Long runs hold no more memory at their end than at their beginning.

#include "bench/kit/memory.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "formulations/variants.h"
#include "tests/every_variant.h"
#include "tests/mechanisms.h"

namespace desmo::memory_test {
namespace {

TEST(HeapInUse, SeesWhatIsHeld) {
  const std::size_t before = bench::heap_in_use();
  if (before == 0) GTEST_SKIP() << "the allocator does not tell";
  const std::vector<char> kept(100'000);
  EXPECT_GE(bench::heap_in_use(), before + kept.size());
}

EVERY_VARIANT(EveryLongRun);

/// UMFPACK's and SPQR's factors are made anew in every step and are not always of one size.
TEST_P(EveryLongRun, HoldsNoMoreMemoryAfterManySteps) {
  constexpr std::size_t size_of_factors = 4096;
  const Model m = four_bar_model(1);
  const auto f = make_formulation(GetParam(), m);
  std::size_t early = 0;
  for (int i = 1; i <= 20'000; ++i) {
    EXPECT_TRUE(f->step(0.01 * i).ok()) << i;
    if (i == 1000) early = bench::heap_in_use();
  }
  EXPECT_LE(bench::heap_in_use(), early + size_of_factors);
}

}  // namespace
}  // namespace desmo::memory_test
