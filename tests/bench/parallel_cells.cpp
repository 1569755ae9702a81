// What several threads solve, as desmo_bench measures and records it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "bench/kit/cell.h"
#include "bench/kit/record.h"
#include "formulations/id.h"

namespace desmo::suite::parallel_cells_test {
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
  Cell cell(find_case("truck_suspension"), 225, *c.variant, options, c.settings);
  cell.verify(references);
  ASSERT_EQ(cell.state, Timed::State::verified) << cell.message;
  EXPECT_EQ(cell.clock, Clock::wall);
  cell.cpu_seconds.push_back(cell.time_afresh());
  EXPECT_GT(cell.cpu_seconds.front(), 0);
  const std::string record = record_text({}, cell.grid, lists_of({&cell}));
  EXPECT_NE(record.find("\"threads\":2"), std::string::npos);
  EXPECT_NE(record.find("\"segment_seconds\""), std::string::npos);
  EXPECT_EQ(record.find("\"segment_samples\""), std::string::npos);
  EXPECT_EQ(record.find("\"segment_updates\""), std::string::npos);
}

}  // namespace
}  // namespace desmo::suite::parallel_cells_test
