#include <gtest/gtest.h>

#include "report/report.h"
#include "report/tables/tables.h"
#include "tests/report/sample.h"

namespace desmo::report::partitions_test {
namespace {

Section section_of(const Json& json) { return partitions(record_from(json)); }

const Table& structure_of(const Section& section) { return section.tables.at(0); }

TEST(Partitions, AreShownFromVersionTwelve) {
  const Document with = make_report(record_from(structured_record()));
  EXPECT_NO_THROW(table_named(with, "partitions"));
  const Document without = make_report(record_from(complete_record()));  // 1.1.0
  for (const Section& section : without.sections)
    EXPECT_EQ(section.title.find("Partitions"), std::string::npos);
}

TEST(Partitions, CountPartsAndTheirUnknowns) {
  const Section section = section_of(structured_record());
  const Table& table = structure_of(section);
  EXPECT_EQ(table.rows.size(), 9u);
  EXPECT_EQ(entry_at(table, {truck, "225", "block"}, "parts").digits[0], "96");
  EXPECT_EQ(entry_at(table, {truck, "225", "block"}, "largest").digits[0], "16");
  EXPECT_EQ(entry_at(table, {truck, "225", "global"}, "largest").digits[0], "218");
}

TEST(Partitions, WriteTheUnknownsOfEachSizeOnce) {
  Json json = structured_record();
  const std::string column = "unknowns of the parts";
  const Section section = section_of(json);
  const Table& table = structure_of(section);
  EXPECT_EQ(entry_at(table, {truck, "225", "global"}, column).shown, "218");
  EXPECT_EQ(entry_at(table, {truck, "225", "group"}, column).shown, "2×39 + 4×19 + 4×16");
  EXPECT_EQ(entry_at(table, {truck, "114", "block"}, column).shown, "16 + 2×4 + 20×3 + 25×1");
  EXPECT_EQ(entry_at(table, {"four_bar", "9", "group"}, column).shown, "2×3 + 2");
  for (Json& structure : json["paper"]["structure"])
    if (structure["coordinates"] == 225 && structure["partition"] == "block")
      structure["parts"].push_back(structure["parts"].back());
  EXPECT_THROW(section_of(json), std::runtime_error);  // one size twice
}

TEST(Partitions, SayWhatTheEquationsKnow) {
  const Section section = section_of(structured_record());
  ASSERT_EQ(section.paragraphs.size(), 3u);
  EXPECT_EQ(section.paragraphs[1],
            "In four_bar, 9 coordinates, the equations know nothing more: every group is one "
            "irreducible block.");
  EXPECT_EQ(section.paragraphs[2],
            "In truck_suspension, 225 coordinates, the bodies give 10 groups of up to 39 unknowns, "
            "the equations 96 blocks of up to 16: 50 of the 218 unknowns can be found one at a "
            "time, and dense elimination (the sum of n³) has 5.9 % of the work.");
}

// What was measured beside the paper's analyses is in no table of the paper's.
TEST(Partitions, StayOutOfThePapersTables) {
  const Json with = structured_record();
  Json without = with;
  without["paper"]["cells"] = Json::array();
  for (const Json& candidate : with["paper"]["cells"])
    if (!candidate["id"].get<std::string>().starts_with("block_"))
      without["paper"]["cells"].push_back(candidate);
  const Document all = make_report(record_from(with)), some = make_report(record_from(without));
  for (const char* name : {"table1_klu", "table2_klu"}) {
    const Table &a = table_named(all, name), &b = table_named(some, name);
    ASSERT_EQ(a.rows.size(), b.rows.size()) << name;
    for (std::size_t i = 0; i < a.rows.size(); ++i)
      for (std::size_t k = 0; k < a.rows[i].size(); ++k)
        EXPECT_EQ(a.rows[i][k].shown, b.rows[i][k].shown) << name;
  }
}

}  // namespace
}  // namespace desmo::report::partitions_test
