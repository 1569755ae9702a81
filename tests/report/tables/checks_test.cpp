#include "tests/report/sample.h"

namespace desmo::report::checks_test {
namespace {

constexpr const char* bare = "group_symbolic_inlined";
constexpr int coordinates = 558;

/// A record in which every piece of a checked motion takes a tenth longer, and the first one
/// 3 ms more.
Json checked_record() {
  Json json = with_windows(complete_record());
  Json checked = candidate_of(json, coordinates, bare);
  checked["id"] = std::string(bare) + "/check:proof";
  double more = 0;
  bool first = true;
  for (Json& window : checked["time"]["windows"]["least"]) {
    const double before = window;
    window = 1.1 * before + (first ? 3e-3 : 0);
    more += window.get<double>() - before;
    first = false;
  }
  for (Json& sample : checked["time"]["seconds"]) sample = sample.get<double>() + more;
  json["paper"]["candidates"].push_back(checked);
  return json;
}

const std::vector<std::string> row{truck, std::to_string(coordinates), bare, "proof"};

TEST(Checks, CostAStepAndTheStart) {
  const Record record = record_from(checked_record());
  const Section section = checks(record);
  ASSERT_EQ(section.tables.size(), 1u);
  ASSERT_EQ(section.tables[0].rows.size(), 1u);
  const auto value = [&](const char* column) {
    return std::stod(entry_at(section.tables[0], row, column).digits.at(0));
  };
  const double without = value("bare"), with = value("checked");
  EXPECT_GT(with, 1.1 * without);
  EXPECT_NEAR(value("more %"), 10, 0.1);
  EXPECT_NEAR(value("start ms"), 3, 0.3);
}

TEST(Checks, WithoutABareRunHaveAMark) {
  Json json = checked_record();
  erase_candidate(json, coordinates, bare);
  const Section section = checks(record_from(json));
  EXPECT_EQ(entry_at(section.tables.at(0), row, "more µs").shown, missing_mark);
}

}  // namespace
}  // namespace desmo::report::checks_test
