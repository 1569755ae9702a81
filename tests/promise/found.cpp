// Scenes in which runs once broke the promise.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "bench/experiments/promise/run_verdict.h"

namespace desmo::promise::found_test {
namespace {

struct Found {
  int scene;  // of seed 1
  const char *id, *name;
  bool is_flagged = false;  // with a cause
};

void PrintTo(const Found& found, std::ostream* out) { *out << found.scene << ", " << found.id; }

class FoundScene : public testing::TestWithParam<Found> {};

TEST_P(FoundScene, IsRightOrFlaggedWithCause) {
  const auto& [scene, id, name, is_flagged] = GetParam();
  const RunVerdict v = verify_id(draw_scene(1, scene), id);
  EXPECT_EQ(v.verdict, is_flagged ? PromiseVerdict::flagged : PromiseVerdict::right)
      << v.what << ": " << v.error << ", allowed " << v.allowed << ", t = " << v.time;
}

constexpr Found all[] = {
    {851, "global_automatic_klu", "AnAssemblyOnAnotherBranch"},
    {188, "block_automatic_klu", "BlocksAssembledOnAnotherBranch"},
    {232, "global_automatic_klu", "AnEstimateThatLacksOutputs"},
    {147, "global_automatic_klu", "ErrorsThatExtendedPrecisionLeavesInDoubt"},
    {991, "global_automatic_klu/stride:2", "ARowCorrectedAndThenDoubted"},
    {473, "global_automatic_klu", "AStepToAnotherBranch"},
    {167, "block_automatic_klu", "AnInstantSolvedTwice"},
    {966, "global_automatic_cholmod", "RatesByNormalEquations"},
    {395, "block_symbolic_inlined/guess:adams8", "AStepFromUnknownAccelerations", true},
    {539, "global_automatic_klu/stride:4", "ARowCorrectedBeforeASingularPosition", true},
    {317, "global_automatic_klu/iterations:1", "TooFewIterationsNearAFold", true},
    {527, "group_automatic_eigen/scalar:float/tolerance:1e-3",
     "BranchesThatSinglePrecisionCannotTell"},
};

INSTANTIATE_TEST_SUITE_P(Promise, FoundScene, testing::ValuesIn(all),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace desmo::promise::found_test
