// Monitors bite: left out, one lets a wrong number through without a flag that the others do not
// find either. Those that no extreme needs are in tests/safety/switches.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <regex>
#include <string>

#include "bench/experiments/extremes/table.h"
#include "formulations/verification/monitor/accuracy_monitor.h"

namespace desmo::extremes::monitors_test {
namespace {

/// What a monitor alone finds.
struct Found {
  Monitor monitor;
  int row;
  const char *cases, *formulation;
};

void PrintTo(const Found& found, std::ostream* out) { *out << found.row << ", " << found.cases; }

class EveryMonitor : public testing::TestWithParam<Found> {
 protected:
  static std::size_t defects(unsigned without) {
    const Found& found = GetParam();
    const auto results =
        row_results(find_extreme(found.row), {.extent = Extent::brief,
                                              .formulations = std::regex(found.formulation),
                                              .cases = std::regex(found.cases),
                                              .without = without});
    EXPECT_FALSE(results.empty());
    return count(results, ExtremeVerdict::defect);
  }
};

TEST_P(EveryMonitor, FindsWhatNoOtherDoes) {
  EXPECT_EQ(defects(0), 0u);
  EXPECT_GT(defects(static_cast<unsigned>(GetParam().monitor)), 0u);
}

constexpr Found all[] = {
    {Monitor::condition, 14, "^approaching a dead point$", "^global_automatic_klu$"},
    {Monitor::residual, 14, "^1e-6$", "^global_automatic_klu$"},
    {Monitor::bounds, 3, "^dead point$", "^global_automatic_klu$"},
    {Monitor::orientation, 9, "^four-bar, K = 1, 50 % off$", "^global_automatic_klu$"},
    {Monitor::continuity, 5, "^Andrews", "^group_symbolic_explicit$"},
    {Monitor::repair, 3, "^dead point$", "^global_automatic_klu$"},
    {Monitor::lengths, 7, "20 m, fast$", "^group_automatic_lapack$"},
};

std::string monitor_name(const testing::TestParamInfo<Found>& info) {
  return std::string(
      std::ranges::find(monitor_names, info.param.monitor, &MonitorName::monitor)->name);
}

INSTANTIATE_TEST_SUITE_P(Monitors, EveryMonitor, testing::ValuesIn(all), monitor_name);

}  // namespace
}  // namespace desmo::extremes::monitors_test
