// Reports of several files: a history, records of other machines, and the site of all.
#include "tests/report/program.h"

namespace desmo::report::several_files_test {
namespace {

namespace fs = std::filesystem;

/// A history of one candidate.
std::string history(const std::vector<Json>& instructions) {
  Json json{{"schema", 2}, {"candidates", {"a"}}};
  for (const Json& count : instructions)
    json["points"].push_back({{"commit", "1"},
                              {"date", "2026-01-01T00:00:00Z"},
                              {"subject", "s"},
                              {"compiler", "c"},
                              {"instructions", Json::array({count})}});
  return json.dump();
}

// A rise has a plus sign, which JSON does not know.
TEST_F(Program, PrintsARiseAsANumber) {
  const std::string with_history = "--history " + write("history.json", history({1000, 1030}));
  ASSERT_EQ(tables("complete.json", with_history + " --table history_moves --format json"), 0);
  const Json row = Json::parse(out_)["sections"][0]["tables"][0]["rows"][0];
  EXPECT_EQ(row["change"]["percent"], 3.0);
  EXPECT_EQ(tables("complete.json", with_history + " --out " + (folder_ / "out").string()), 0);
  for (const double no_count : {0.5, 1e19}) {
    write("history.json", history({1000, no_count}));
    EXPECT_EQ(tables("complete.json", with_history), 65);
    EXPECT_CONTAINS(err_, "history.json: /points/1/instructions/0: a whole number from 1 to 1e15");
  }
}

/// The newest record as another machine would have made it.
std::string of_other_machine(const std::string& other) {
  const Json record = origins_record();
  return replaced_everywhere(record.dump(), record["record"]["machine"]["cpu"], other);
}

TEST_F(Program, ShowsSpeedUpsBesideThoseOfOtherMachines) {
  const std::string alone = (folder_ / "alone").string(), both = (folder_ / "both").string(),
                    title = "Speed-ups here and on other machines";
  Json changed = Json::parse(of_other_machine("Other CPU"));
  const std::string own = data_file(origins).string(), other = write("other.json", changed.dump()),
                    third = write("third.json", of_other_machine("Third CPU"));
  erase_candidate(changed, 114, "group_symbolic_klu");
  const std::string less = write("less.json", changed.dump());
  ASSERT_EQ(tables(origins, "--out " + alone), 0) << err_;
  const auto without = files_in(alone);
  EXPECT_EQ(without.count("machines.csv"), 0u);
  EXPECT_LACKS(without.at("report.html"), title);
  ASSERT_EQ(tables(origins,
                   "--out " + both + " --beside " + own + " " + less + " " + other + " " + third),
            0)
      << err_;
  auto with = files_in(both);
  const std::string table = with.at("machines.csv");
  EXPECT_TRUE(table.starts_with("case,coordinates,id,A ratio,A low,A high,B ratio,")) << table;
  EXPECT_CONTAINS(table, "group_symbolic_klu,");  // has most in common
  EXPECT_EQ(with.count("machines_2.csv"), 1u);
  EXPECT_EQ(with.count("machines_3.csv"), 0u);
  const std::string page = with.at("report.html");
  EXPECT_CONTAINS(page, "B: Third CPU");
  const std::size_t section = page.find(title), end = page.find("</details>\n<h2>", section);
  ASSERT_LT(section, end);
  EXPECT_LACKS(page.substr(section, end - section), " seconds</th>");
  // All else is as without them, the first screen before all.
  for (const char* name : {"report.html", "tables.txt", "tables.md", "tables.json"})
    with.erase(name);
  for (const auto& [name, content] : without)
    if (with.count(name)) {
      EXPECT_EQ(with.at(name), content) << name;
    }
  const std::string first_screen = without.at("report.html");
  EXPECT_TRUE(page.starts_with(first_screen.substr(0, first_screen.find("<h2>About"))));
}

TEST_F(Program, WhatStandsBesideMeasuredTheSameOnAnotherMachine) {
  const std::string none = "No other machine's record here has speed-ups of the same work";
  ASSERT_EQ(tables(origins, "--all --beside " + data_file(origins).string()), 0);
  EXPECT_CONTAINS(out_, none);
  Json other = Json::parse(of_other_machine("Other CPU"));
  set_motion(other, 3);
  const std::string beside = " --beside " + write("other.json", other.dump());
  ASSERT_EQ(tables(origins, "--all" + beside), 0) << err_;
  EXPECT_CONTAINS(out_, none);
  EXPECT_EQ(tables(origins, "--table machines" + beside), 64);
}

TEST_F(Program, WritesASiteOfAllRecords) {
  const fs::path results = folder_ / "results", out = folder_ / "site";
  write("results/records/one-paper.json", origins_record().dump());
  write("results/records/two-paper.json", of_other_machine("Other CPU"));
  write("results/history.json", history({nullptr}));
  const std::string command = "site " + results.string() + " --out " + out.string();
  ASSERT_EQ(report(command), 0) << err_;
  const std::string index = files_in(out).at("index.html");
  for (const std::string name : {"one-paper", "two-paper", "history"}) {
    EXPECT_CONTAINS(index, "href=\"" + name + "/report.html\"") << name;
    EXPECT_EQ(files_in(out / name).count("machines.vl.json"), name != "history") << name;
    EXPECT_CONTAINS(files_in(out / name).at("report.html"), "../index.html");
  }
  for (const char* part :
       {"<td>Other CPU</td>", ">The paper's experiment</a>", "<li>fewer instructions: 0 of 1</li>"})
    EXPECT_CONTAINS(index, part);
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 4);
  write("results/history.json", R"({"schema": 1})");
  fs::remove_all(out);
  EXPECT_EQ(report(command), 65);
  EXPECT_CONTAINS(err_, "history.json: /schema: only schema 2 is read");
  EXPECT_FALSE(fs::exists(out));
  write("results/records/one-paper.json.gz", origins_record().dump());
  EXPECT_EQ(report(command), 65);
  EXPECT_CONTAINS(err_, "records: has two files of the record one-paper; ");
  EXPECT_EQ(report("site " + std::string(300, 'x') + " --out " + out.string()), 65);
  EXPECT_CONTAINS(err_, "records: there is no folder");
}

}  // namespace
}  // namespace desmo::report::several_files_test
