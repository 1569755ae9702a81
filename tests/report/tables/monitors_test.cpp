#include <gtest/gtest.h>

#include "report/report.h"
#include "report/tables/tables.h"
#include "tests/report/sample.h"

namespace desmo::report::monitors_test {
namespace {

constexpr const char* bare = "group_symbolic_inlined";
constexpr int coordinates = 558;

/// A record in which every piece of a monitored motion takes a tenth longer, and the first one
/// 3 ms more.
Json monitored_record() {
  Json json = with_windows(complete_record());
  Json monitored = candidate_of(json, truck, coordinates, bare);
  monitored["id"] = std::string(bare) + "/monitored";
  double more = 0;
  bool first = true;
  for (Json& window : monitored["time"]["windows"]["least"]) {
    const double before = window;
    window = 1.1 * before + (first ? 3e-3 : 0);
    more += window.get<double>() - before;
    first = false;
  }
  for (Json& sample : monitored["time"]["seconds"]) sample = sample.get<double>() + more;
  json["paper"]["cells"].push_back(monitored);
  return json;
}

TEST(Monitors, CostOfAStepAndOfTheStart) {
  const Record record = record_from(monitored_record());
  const Section section = monitors(record);
  ASSERT_EQ(section.tables.size(), 1u);
  ASSERT_EQ(section.tables[0].rows.size(), 1u);
  const std::vector<std::string> row{truck, std::to_string(coordinates), bare};
  const auto value = [&](const char* column) {
    return std::stod(entry_at(section.tables[0], row, column).digits.at(0));
  };
  const double without = value("bare"), with = value("monitored");
  EXPECT_GT(with, 1.1 * without);
  EXPECT_NEAR(value("more %"), 10, 0.1);
  EXPECT_NEAR(value("start ms"), 3, 0.3);
}

TEST(Monitors, HaveNoTableWhereNoRunWasMonitored) {
  EXPECT_TRUE(monitors(record_from(complete_record())).tables.empty());
}

TEST(Monitors, WithoutABareRunHaveAMark) {
  Json json = monitored_record();
  erase_candidate(json, truck, coordinates, bare);
  const Section section = monitors(record_from(json));
  const std::vector<std::string> row{truck, std::to_string(coordinates), bare};
  EXPECT_EQ(entry_at(section.tables.at(0), row, "more µs").shown, missing_mark);
}

}  // namespace
}  // namespace desmo::report::monitors_test
