// The short form of every row of the table of extremes, in formulations of every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <regex>
#include <set>
#include <string>

#include "bench/experiments/extremes/table.h"

namespace desmo {

/// Prints a row in names and failures of tests.
inline void PrintTo(const Extreme& row, std::ostream* out) { *out << row.number; }

}  // namespace desmo

namespace desmo::extremes::rows_test {
namespace {

class EveryExtreme : public testing::TestWithParam<Extreme> {};

std::string row_name(const testing::TestParamInfo<Extreme>& info) {
  std::string name = std::to_string(info.param.number) + "_" + std::string(info.param.name);
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

TEST_P(EveryExtreme, IsAsExpected) {
  const char* const formulations =
      DESMO_SANITIZED ? "^(global_automatic_klu|group_symbolic_explicit)$"
                      : "^(global_automatic_klu|group_automatic_eigen|block_symbolic_inlined|"
                        "group_symbolic_explicit)$";
  const std::vector<Result> results =
      row_results(GetParam(), {.extent = Extent::brief, .formulations = std::regex(formulations)});
  std::set<std::string> cases, as_expected;
  for (const Result& r : results) {
    cases.insert(r.case_name);
    if (r.verification.verdict == ExtremeVerdict::as_expected) as_expected.insert(r.case_name);
    EXPECT_TRUE(r.verification.verdict == ExtremeVerdict::as_expected ||
                r.verification.verdict == ExtremeVerdict::not_applicable)
        << r.case_name << ", " << r.id << ": " << r.verification.reason;
  }
  EXPECT_FALSE(cases.empty());
  EXPECT_EQ(as_expected, cases);  // each in some formulation
}

INSTANTIATE_TEST_SUITE_P(Rows, EveryExtreme, testing::ValuesIn(all_extremes()), row_name);

}  // namespace
}  // namespace desmo::extremes::rows_test
