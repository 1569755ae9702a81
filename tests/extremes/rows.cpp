// The short form of every row of the table of extremes, in formulations of every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <regex>
#include <string>

#include "tests/extremes/known_defects.h"

namespace desmo {

/// How a test's name and its failures show a row.
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

/// What is worst comes last.
int badness(Verdict v) {
  return v == Verdict::defect ? 3 : v == Verdict::missed ? 2 : v == Verdict::as_expected ? 1 : 0;
}

/// Of each case in the order of its name, the worst result.
std::map<std::string, Result> worst_by_case(const std::vector<Result>& results) {
  std::map<std::string, Result> worst;
  for (const Result& r : results) {
    const auto [it, is_new] = worst.try_emplace(r.case_name, r);
    if (!is_new && badness(r.verification.verdict) > badness(it->second.verification.verdict))
      it->second = r;
  }
  return worst;
}

TEST_P(EveryExtreme, IsAsExpectedOrKnownNotToBe) {
  const std::vector<Result> results =
      row_results(GetParam(), {.extent = Extent::brief,
                               .formulations = std::regex("^(global_automatic_klu|"
                                                          "group_automatic_eigen|"
                                                          "block_symbolic_inlined|"
                                                          "group_symbolic_explicit)$")});
  EXPECT_FALSE(results.empty());
  for (const auto& [name, r] : worst_by_case(results)) {
    const Verdict verdict = r.verification.verdict;
    const KnownDefect* known = find_known_defect(GetParam().number, name);
    if (!known) {
      EXPECT_EQ(badness(verdict), badness(Verdict::as_expected))
          << name << ", " << r.id << ": " << r.verification.reason;
    } else {
      EXPECT_EQ(badness(verdict), badness(known->verdict))
          << name << " does better or worse than known: change tests/extremes/known_defects.cpp; "
          << r.id << ": " << r.verification.reason;
    }
  }
  for (const KnownDefect& known : known_defects())
    EXPECT_TRUE(known.row != GetParam().number || worst_by_case(results).contains(known.case_name))
        << "there is no case " << known.case_name;
}

INSTANTIATE_TEST_SUITE_P(Rows, EveryExtreme, testing::ValuesIn(all_extremes()), row_name);

}  // namespace
}  // namespace desmo::extremes::rows_test
