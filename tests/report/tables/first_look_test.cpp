// A record of two repetitions, as bench/run --quick makes it: orders of magnitude, said once.

#include "report/formats/formats.h"
#include "tests/report/sample.h"

namespace desmo::report::first_look_test {
namespace {

/// A record with timing windows and a checked run that seems to be faster than a bare one, of
/// which every time has so many repetitions.
Json record_of(std::size_t repetitions) {
  Json json = complete_record();
  Json checked = candidate_of(json, 558, "group_symbolic_inlined");
  checked["id"] = "group_symbolic_inlined/check:proof";
  for (Json& sample : checked["time"]["seconds"]) sample = 0.71 * sample.get<double>();
  json["paper"]["candidates"].push_back(checked);
  keep_samples(json, repetitions);
  return with_samples_of_windows(json);
}

/// Tells whether digits are an order of magnitude: one of them is not zero.
bool is_order(const std::string& digits) {
  return std::ranges::count_if(digits, [](char c) { return '1' <= c && c <= '9'; }) == 1;
}

TEST(FirstLook, HasOneDigitAndNoInterval) {
  const Document document = make_report(record_from(record_of(2)));
  int numbers = 0;
  for (const Table& table : tables_of(document)) {
    if (table.name == "time_split") continue;  // measured apart, by more passes
    for (const auto& row : table.rows)
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::vector<std::string>& quantities = table.columns[i].quantities;
        const bool ours =
            std::ranges::none_of(row, [](const Entry& entry) { return entry.shown == "paper"; });
        if (!ours || table.columns[i].name == "MA27 (the paper)" ||
            row.front().shown == "MA27 (the paper)" || !row[i].has_number())
          continue;
        for (const char* timed : {"seconds", "microseconds", "speed_up", "ratio"})
          if (!quantities.empty() && quantities[0] == timed &&
              table.columns[i].name != "set-up s" && row[i].note != "reference") {
            ++numbers;
            EXPECT_TRUE(is_order(row[i].digits[0])) << table.name << ": " << row[i].shown;
            EXPECT_EQ(row[i].shown, row[i].digits[0]);
          }
        for (std::size_t k = 0; k < quantities.size(); ++k)
          for (const char* spread : {"low", "high", "half_range", "least", "largest", "percent"})
            if (quantities[k] == spread && k < row[i].digits.size()) {
              EXPECT_EQ(row[i].digits[k], "") << table.name << ": " << row[i].shown;
            }
      }
  }
  EXPECT_GT(numbers, 100);
}

TEST(FirstLook, SaysOnceWhatItIsAndLeavesOutWhatItCannotShow) {
  for (const auto& print : {to_terminal, to_markdown, to_html}) {
    std::string text = print(make_report(record_from(record_of(2))));
    if (const std::size_t style = text.find("</style>"); style != text.npos) text.erase(0, style);
    EXPECT_EQ(count(text, "A first look: "), 1u);
    EXPECT_EQ(count(text, "nterval"), 1u);
    for (const char* absent : {"What checks cost", "inconclusive", "two runs", "half the range"})
      EXPECT_EQ(count(text, absent), 0u) << absent;
  }
}

TEST(FirstLook, IsNoneWithThreeRepetitions) {
  const std::string text = to_terminal(make_report(record_from(record_of(3))));
  for (const char* part : {"What checks cost", "nterval", "inconclusive"})
    EXPECT_GT(count(text, part), 0u) << part;
  EXPECT_EQ(count(text, "A first look: "), 0u);
}

}  // namespace
}  // namespace desmo::report::first_look_test
