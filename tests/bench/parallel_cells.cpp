// What several threads solve, as desmo_bench measures and records it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/request.h"
#include "bench/kit/record/record.h"
#include "formulations/id.h"

namespace desmo::paper::parallel_cells_test {
namespace {

TEST(ParallelSegments, OfSeveralThreadsCountNoWork) {
  TimingWindows windows(500, Clock::wall);
  windows.begin();
  for (int i = 0; i < 500; ++i) {
    if (i == 30) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    windows.passed(7);
  }
  EXPECT_EQ(std::ranges::count(windows.updates(), 0), 25);
  EXPECT_GE(windows.least()[1], 2e-3);  // sleeping takes no CPU time
}

TEST(ParallelCells, OfSeveralThreadsAreTimedByTheWallClock) {
  const Configuration c = parse_id("group_symbolic_explicit/segments:4/threads:2");
  Options options;
  options.duration = 10;
  ReferenceCache references;
  CaseCandidate cell(find_case("truck_suspension"), 225, *c.variant, options, c.settings);
  cell.verify(references);
  ASSERT_EQ(cell.state, Candidate::State::verified) << cell.message;
  EXPECT_EQ(cell.clock, Clock::wall);
  cell.seconds.push_back(cell.time_afresh());
  EXPECT_GT(cell.seconds.front(), 0);
  const std::string record = record_text({}, cell.grid, lists_of({&cell}));
  EXPECT_NE(record.find("\"threads\":2"), std::string::npos);
  EXPECT_NE(record.find("\"time\":{\"clock\":\"wall\","), std::string::npos);
  EXPECT_EQ(record.find("\"windows\""), std::string::npos);
}

/// What several threads are compared with: the same on one, by the same clock, under its own name.
TEST(ParallelCells, StandBesideOneThreadByTheWallClock) {
  std::set<std::string> names;
  for (const auto& cell : make_case_candidates({})) {
    names.insert(cell->name());
    EXPECT_EQ(cell->clock == Clock::wall,
              cell->threads > 1 || cell->name().ends_with("/clock:wall"))
        << cell->name();
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
}  // namespace desmo::paper::parallel_cells_test
