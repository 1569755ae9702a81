// The record of a scene of the user's own: nothing is shown of mechanisms that it does not hold,
// and there is no table without rows and no figure without marks.

#include "report/formats/formats.h"
#include "tests/report/sample.h"

namespace desmo::report::own_scene_test {
namespace {

/// The truck's largest size under another name.
Json scene_record() {
  Json json = complete_record(), kept = Json::array();
  for (Json& candidate : json["paper"]["candidates"])
    if (candidate["case"] == truck && candidate["coordinates"] == 558) {
      candidate["case"] = "slider_crank";
      candidate["coordinates"] = 9;
      kept.push_back(candidate);
    }
  json["paper"] = {{"candidates", kept}};
  return json;
}

TEST(OwnScene, ShowsNothingOfOtherMechanisms) {
  for (const std::size_t repetitions : {2, 3}) {
    Json json = scene_record();
    keep_samples(json, repetitions);
    const Document document = make_report(record_from(json));
    const std::string text = to_markdown(document);
    for (const char* absent : {"truck", "four\\_bar", "MA27", "The filed records"})
      EXPECT_LACKS(text, absent) << absent << " in " << text;
    EXPECT_TRUE(document.sections.front().front);
    EXPECT_TRUE(document.sections.front().paragraphs.front().starts_with(
        repetitions < 3 ? "A first look: "
                        : "On one thread, a generated elimination of slider_crank with 9 "));
    EXPECT_EQ(table_named(document, "best").title,
              "One thread over the best global reference: slider_crank, 9 coordinates");
    EXPECT_EQ(table_named(document, "best").rows.size(), 2u);
    EXPECT_FALSE(table_named(document, "formulations_slider_crank_9").rows.empty());
  }
}

TEST(OwnScene, WithoutAnyTimeSaysSo) {
  Json json = scene_record();
  for (Json& candidate : json["paper"]["candidates"]) fail(candidate);
  const Document document = make_report(record_from(json));
  EXPECT_EQ(document.sections.front().paragraphs.at(0),
            "No formulation that solves everything has a time on one thread.");
  EXPECT_TRUE(document.sections.front().tables.empty());
  EXPECT_EQ(table_named(document, "formulations_slider_crank_9").figure, "");
}

TEST(Document, LeavesOutTablesWithoutRowsAndFiguresWithoutMarks) {
  Table table{.name = "t",
              .title = "T",
              .columns = {{"id", {}}, {"time", {"seconds"}}, {"error", {"error"}}},
              .rows = {{"a", note_entry(failed_mark), {"1", {"1"}, {}}}}};
  table.figure = "peers";
  Table empty = table;
  empty.rows.clear();
  Document document{"D", {}};
  document.add({"S", {}, {empty, table}});
  document.add({"E", {}, {empty}});
  ASSERT_EQ(document.sections.size(), 1u);
  ASSERT_EQ(document.sections[0].tables.size(), 1u);
  EXPECT_EQ(document.sections[0].tables[0].figure, "peers");
  table.drawn = "time";
  document.add({"S", {}, {table}});
  EXPECT_EQ(document.sections[1].tables[0].figure, "");
  table.rows.push_back({"b", {"1.00 reference", {"1.00"}, "reference"}, "—"});
  document.add({"S", {}, {table}});
  EXPECT_EQ(document.sections[2].tables[0].figure, "");
  table.rows.push_back({"c", {"2.0", {"2.0"}, {}}, "—"});
  document.add({"S", {}, {table}});
  EXPECT_EQ(document.sections[3].tables[0].figure, "peers");
}

}  // namespace
}  // namespace desmo::report::own_scene_test
