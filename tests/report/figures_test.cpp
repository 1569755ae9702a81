#include "report/figures/figures.h"

#include <gtest/gtest.h>

#include <set>

#include "report/tables/tables.h"
#include "tests/report/sample.h"

namespace desmo::report::figures_test {
namespace {

Json data_of(const Json& record, std::size_t figure) {
  return Json::parse(figures(record_from(record)).at(figure).content)["data"]["values"];
}

Json find(const Json& values, const Json& wanted) {
  for (const Json& value : values) {
    bool found = true;
    for (const auto& [key, expected] : wanted.items()) found = found && value[key] == expected;
    if (found) return value;
  }
  return nullptr;
}

TEST(Figures, AreVegaLiteWithInlineData) {
  const auto files = figures(record_from(complete_record()));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].file_name, "figure5.vl.json");
  EXPECT_EQ(files[1].file_name, "figure6.vl.json");
  for (const NewFile& file : files) {
    const Json spec = Json::parse(file.content);
    EXPECT_NE(spec["$schema"].get<std::string>().find("vega-lite/v5"), std::string::npos);
    EXPECT_FALSE(spec["data"].contains("url"));
    EXPECT_NE(spec["title"]["subtitle"].dump().find("Synthetic CPU"), std::string::npos);
  }
}

// Every number drawn is one of the table's, every text of the hover is the table's.
TEST(Figures, DrawWhatTheirTablesSay) {
  const Record record = record_from(complete_record());
  const auto files = figures(record);
  const std::vector<Table> tables{figure_of_times(record), figure_of_speed_ups(record)};
  const std::vector<std::size_t> labels{2, 1};  // columns before the numbers
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Json spec = Json::parse(files[i].content);
    EXPECT_EQ(files[i].file_name, tables[i].name + ".vl.json");
    EXPECT_EQ(spec["title"]["text"], tables[i].title);
    std::multiset<std::string> drawn, printed;
    for (const Json& value : spec["data"]["values"]) {
      std::string numbers = value["shown"];
      for (const char* quantity : {"seconds", "median", "speed_up", "low", "high"})
        if (value.contains(quantity)) numbers += " " + value[quantity].dump();
      drawn.insert(numbers);
    }
    for (const auto& row : tables[i].rows)
      for (std::size_t column = labels[i]; column < row.size(); ++column) {
        std::string numbers = row[column].shown;
        for (std::size_t q = 0; q < 3; ++q) {
          if (tables[i].columns[column].quantities[q] == "repetitions") continue;
          const bool known = q < row[column].digits.size() && !row[column].digits[q].empty();
          if (known || q == 0)
            numbers += " " + (known ? Json::parse(row[column].digits[q]) : Json()).dump();
        }
        printed.insert(numbers);
      }
    EXPECT_EQ(drawn, printed);
  }
}

TEST(FigureFive, ShowsOursAndThePapers) {
  Json record = complete_record();
  set_samples(record, 336, "group_symbolic_klu", {0.3, 0.1, 0.2});
  const Json values = data_of(record, 0);
  EXPECT_EQ(values.size(), 4u * 7 * 5);
  const Json ours =
      find(values, {{"panel", "klu"}, {"analysis", "TS-TPS sparse"}, {"coordinates", 336}});
  EXPECT_EQ(ours["seconds"], 0.2);
  EXPECT_FALSE(ours.contains("median"));  // it is the time
  const Json disturbed =
      find(data_of(with_windows(record), 0),
           {{"panel", "klu"}, {"analysis", "TS-TPS sparse"}, {"coordinates", 336}});
  EXPECT_EQ(disturbed["seconds"], 0.1);
  EXPECT_EQ(disturbed["median"], 0.2);
  EXPECT_EQ(find(values, {{"panel", "MA27 (the paper)"},
                          {"analysis", "TS-G sparse"},
                          {"coordinates", 558}})["seconds"],
            7.1);
  EXPECT_TRUE(find(values, {{"panel", "MA27 (the paper)"}, {"analysis", "FBL-TP"}})["seconds"]
                  .is_null());  // the paper gives no number
}

TEST(FigureFive, HasNoPointForAFailedCell) {
  Json record = complete_record();
  fail_candidate(record, "truck_suspension", 336, "group_symbolic_lapack");
  for (const char* family : {"cholmod", "umfpack", "klu"}) {
    const Json point =
        find(data_of(record, 0),
             {{"panel", family}, {"analysis", "TS-TPS LAPACK"}, {"coordinates", 336}});
    EXPECT_TRUE(point["seconds"].is_null());
    EXPECT_EQ(point["note"], failed_mark);
  }
}

TEST(FigureFive, NamesTheMotionsThatDiffer) {
  Json record = complete_record();
  set_motion(record, 2);
  const Json values = data_of(record, 0);
  EXPECT_FALSE(find(values, {{"panel", "MA27 (the paper, 30 s)"}}).is_null());
  EXPECT_FALSE(find(values, {{"panel", "klu (ours, 2 s)"}}).is_null());
  EXPECT_TRUE(find(values, {{"panel", "klu"}}).is_null());
  const Json spec = Json::parse(figures(record_from(record)).front().content);
  EXPECT_EQ(spec["facet"]["sort"], Json({"MA27 (the paper, 30 s)", "cholmod (ours, 2 s)",
                                         "umfpack (ours, 2 s)", "klu (ours, 2 s)"}));
  const std::string subtitle = spec["title"]["subtitle"].dump();
  EXPECT_NE(subtitle.find("CPU time of 2 s of motion"), std::string::npos);
  EXPECT_NE(subtitle.find("the paper's 30 s: these times are not to be"), std::string::npos);
}

TEST(Figures, SkipFamiliesWithoutACellAndKeepTheColours) {
  Json record = complete_record();
  for (const char* family : {"cholmod", "umfpack"}) erase_family(record, family);
  const auto files = figures(record_from(record));
  for (const NewFile& file : files)
    for (const char* family : {"cholmod", "umfpack"})
      EXPECT_EQ(file.content.find(family), std::string::npos) << file.file_name;
  const Json scale = Json::parse(files[1].content)["layer"][0]["encoding"]["color"]["scale"];
  EXPECT_EQ(scale["domain"], Json({"MA27 (the paper)", "klu"}));
  EXPECT_EQ(scale["range"], Json({"#3b3b3b", "#f2e3c2"}));
  EXPECT_EQ(Json::parse(files[1].content)["params"][0]["value"], scale["domain"]);
}

TEST(FigureSix, ShowsTheMeansOfTableTwo) {
  const Json record = complete_record();
  const Json values = data_of(record, 1);
  EXPECT_EQ(values.size(), 4u * 4);
  for (const char* family : {"cholmod", "umfpack", "klu"}) {
    const Entry mean =
        entry_at(speed_ups(record_from(record), family), {"mean", "ours"}, "TS-TPA_LAP");
    const Json bar = find(values, {{"solver", family}, {"variant", "TS-TPA LAPACK"}});
    EXPECT_EQ(bar["label"], mean.digits[0]);
    EXPECT_EQ(bar["low"], std::stod(mean.digits[1]));
    EXPECT_EQ(bar["high"], std::stod(mean.digits[2]));
  }
}

TEST(FigureSix, MarksIncompleteAndMissingMeans) {
  Json record = complete_record();
  fail_candidate(record, "truck_suspension", 336, "group_automatic_klu");
  for (const int size : {114, 225, 336, 447, 558})
    erase_candidate(record, "truck_suspension", size, "group_symbolic_klu");
  const Json values = data_of(record, 1);
  const std::string label =
      find(values, {{"solver", "klu"}, {"variant", "TS-TPA sparse"}})["label"];
  EXPECT_EQ(label.back(), '*');
  const Json none = find(values, {{"solver", "klu"}, {"variant", "TS-TPS sparse"}});
  EXPECT_TRUE(none["speed_up"].is_null());
  EXPECT_EQ(none["label"], "n/a");
}

}  // namespace
}  // namespace desmo::report::figures_test
