// What several threads solve, as desmo_bench measures and records it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/measurement.h"
#include "bench/experiments/paper/request.h"
#include "formulations/id.h"

namespace desmo::paper::parallel_candidates_test {
namespace {

TEST(ParallelSegments, OfSeveralThreadsCountNoWork) {
  TimingWindows windows(500, Clock::wall);
  windows.begin();
  for (int i = 0; i < 500; ++i) {
    if (i == 30) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    windows.count_instant(7);
  }
  EXPECT_EQ(std::ranges::count(windows.updates(), 0), 25);
  EXPECT_GE(windows.least()[1], 2e-3);  // sleeping takes no CPU time
}

TEST(ParallelCandidates, OfSeveralThreadsAreTimedByTheWallClock) {
  Options options;
  options.duration = 10;
  CaseCandidate candidate(measured_case(find_case("truck_suspension"), 225, options),
                          {parse_id("group_symbolic_explicit/segments:4/threads:2")}, options);
  candidate.verify();
  ASSERT_TRUE(candidate.is_verified()) << candidate.message();
  EXPECT_EQ(candidate.clock(), Clock::wall);
  const std::optional<double> seconds = candidate.time_afresh();
  ASSERT_TRUE(seconds) << candidate.message();
  EXPECT_GT(*seconds, 0);
  candidate.add_sample(*seconds);
  const std::string record = lists_of({&candidate}).dump();
  EXPECT_NE(record.find("\"threads\":2"), std::string::npos);
  EXPECT_NE(record.find("\"time\":{\"clock\":\"wall\","), std::string::npos);
  EXPECT_EQ(record.find("\"windows\""), std::string::npos);
}

/// What several threads are compared with: the same on one, by the same clock, under its own name.
TEST(ParallelCandidates, StandBesideOneThreadByTheWallClock) {
  std::set<std::string> names;
  for (const auto& candidate : make_case_candidates({})) {
    names.insert(candidate->name());
    EXPECT_EQ(candidate->clock() == Clock::wall,
              candidate->threads() > 1 || candidate->name().ends_with("/clock:wall"))
        << candidate->name();
  }
  for (const auto& request : make_request_candidates({})) names.insert(request->name());
  int several = 0;
  for (std::string name : names) {
    const std::size_t at = name.find("/threads:2");
    if (at == name.npos) continue;
    ++several;
    const std::size_t request = std::min(name.find("/request:"), name.size());
    name.insert(request, "/clock:wall");
    EXPECT_TRUE(names.contains(name.erase(at, std::string("/threads:2").size()))) << name;
  }
  EXPECT_GT(several, 0);
}

}  // namespace
}  // namespace desmo::paper::parallel_candidates_test
