// Options of the paper's experiment.

#include "bench/experiments/paper/options.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace desmo::paper::options_test {
namespace {

Options parse(std::vector<std::string> arguments, std::vector<std::string>* rest = nullptr) {
  const Options o = take_options(arguments);
  if (rest) *rest = arguments;
  return o;
}

TEST(BenchOptions, TakeTheirOwnAndLeaveTheRest) {
  std::vector<std::string> rest;
  const Options o = parse({"x", "--step=0.02", "--benchmark_filter=a", "--duration", "3",
                           "--record=out.json", "--dense-limit=9", "--slow-limit=8"},
                          &rest);
  EXPECT_EQ(o.step, 0.02);
  EXPECT_EQ(o.duration, 3);
  EXPECT_EQ(o.dense_limit, 9);
  EXPECT_EQ(o.slow_limit, 8);
  EXPECT_EQ(o.record, "out.json");
  EXPECT_EQ(rest, (std::vector<std::string>{"x", "--benchmark_filter=a"}));
}

TEST(BenchOptions, StandForFlagsOfGoogleBenchmarkThatTheUserMayGiveHimself) {
  std::vector<std::string> rest;
  const Options quick = parse({"--benchmark_repetitions=7", "--quick", "--filter", "klu"}, &rest);
  const TimeGrid own{2, 0.01, 3001}, brief{2, 0.01, 101};
  const auto end = [](const TimeGrid& grid) { return grid.time(grid.instants - 1); };
  EXPECT_EQ(end(chosen_grid(own, quick)), 3.5);
  EXPECT_EQ(end(chosen_grid(brief, quick)), 3);
  EXPECT_EQ(end(chosen_grid(own, {})), 32);
  EXPECT_EQ(rest, (std::vector<std::string>{"--benchmark_filter=klu", "--benchmark_repetitions=2",
                                            "--benchmark_repetitions=7"}));
  EXPECT_EQ(end(chosen_grid(own, parse({"--quick", "--duration=3", "--repetitions", "4"}, &rest))),
            5);
  EXPECT_EQ(rest, std::vector<std::string>{"--benchmark_repetitions=4"});
}

TEST(BenchOptions, RefuseWhatIsNotAPositiveNumber) {
  for (const char* bad : {"--step=0", "--step=-1", "--step=nan", "--step=inf", "--step=1x",
                          "--dense-limit=2.5", "--duration=1e999"})
    EXPECT_THROW(parse({"x", bad}), std::invalid_argument) << bad;
  EXPECT_THROW(parse({"x", "--record"}), std::invalid_argument);
}

}  // namespace
}  // namespace desmo::paper::options_test
