// desmo_report and the render script as a user runs them: exit codes, messages, files.
#include "tests/report/program.h"

#include <sstream>

#include "cases/io/text_file.h"
#include "tests/report/sample.h"

namespace desmo::report::program_test {
namespace {

namespace fs = std::filesystem;

TEST_F(Program, PrintsWhatStandsInFrontAndWritesNothing) {
  EXPECT_EQ(tables("complete.json"), 0);
  EXPECT_CONTAINS(out_, "The paper's best variant");
  EXPECT_CONTAINS(out_, "--all");
  EXPECT_LACKS(out_, "Table 1 (klu)");
  EXPECT_EQ(err_, "");
}

TEST_F(Program, PrintsAllTablesOrOne) {
  EXPECT_EQ(tables("complete.json", "--all"), 0);
  EXPECT_CONTAINS(out_, "Table 1 (klu)");
  EXPECT_CONTAINS(out_, "Table 2 (umfpack)");
  const std::string all = out_;
  EXPECT_EQ(tables("complete.json", "--format terminal"), 0);
  EXPECT_EQ(out_, all);
  EXPECT_EQ(tables("complete.json", "--table table1_klu --table best --format markdown"), 0);
  EXPECT_CONTAINS(out_, "**Table 1");
  EXPECT_CONTAINS(out_, "**One thread over");
  EXPECT_LACKS(out_, "**Table 2");
}

TEST_F(Program, EndsWithACodeAndSaysWhatIsWrong) {
  const fs::path whole = data_file("complete.json");
  Json failed = complete_record();
  fail_candidate(failed, truck, 114, "group_symbolic_klu");
  const std::string complete = "tables " + whole.string() + " ",
                    data = "tables " + data_file("").string(), file = write("file", "in the way"),
                    failing = write("failed.json", failed.dump()),
                    truncated = write("truncated.json", read_text(whole).substr(0, 28669)),
                    unknown = write("unknown_version.json",
                                    changed(complete_record(), "/schema_version", "3.0.0").dump());
  struct Ended {
    std::string arguments;
    int code;
    std::string said;
  };
  for (const auto& [arguments, code, said] : std::vector<Ended>{
           {"--help", 0, "check"},
           {"--version", 0, "desmo_report 0."},
           {"tables " + failing + " --all", 0, failed_mark},
           {"", 64, "subcommand is required"},
           {"tables", 64, "record is required"},
           {"chairs", 64, "subcommand is required"},
           {complete + "--format pdf", 64, "pdf"},
           {complete + "--table chair", 64,
            "no table chair in this report; there are: figure6, best, "},
           {complete + "--table table1", 64,
            "no table table1 in this report; the nearest: table1_cholmod, table1_umfpack, "
            "table1_klu; there are: figure6, best, "},
           {complete + "--table pr0venance", 64, "; the nearest: provenance; "},
           {complete + "--beside no_such.json", 65, "no_such.json: there is no such file"},
           {data + "no_such.json", 65, "no_such.json: there is no such file"},
           {"tables " + truncated, 65, "truncated.json: line 135, column 230: "},
           {"tables " + unknown + " --out " + (folder_ / "out").string(), 65,
            "unknown_version.json: /schema_version: schema version 3.0.0, and this program reads "
            "2.x"},
           {complete + "--out " + file, 74, file},
           {complete + "--out /proc/nowhere", 74, "/proc/nowhere"},
           {complete + ">/dev/full", 74, "standard output cannot be written"}}) {
    EXPECT_EQ(report(arguments), code) << arguments;
    EXPECT_CONTAINS(out_ + err_, said) << arguments;
    EXPECT_EQ(code == 0 ? err_ : out_, "") << arguments;
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Program, PrintsForProgramsNothingButWhatTheyRead) {
  const fs::path folder = folder_ / "out";
  ASSERT_EQ(tables("complete.json", "--out " + folder.string()), 0);
  const auto files = files_in(folder);
  EXPECT_EQ(tables("complete.json", "--table best --format csv"), 0);
  EXPECT_EQ(out_, files.at("best.csv"));
  EXPECT_TRUE(out_.starts_with("what,id,")) << out_;
  EXPECT_EQ(tables("complete.json", "--table best --table provenance --format csv"), 0);
  EXPECT_TRUE(out_.starts_with("table,what,id,")) << out_;
  EXPECT_CONTAINS(out_, "\n\ntable,what,value\nprovenance,");
  EXPECT_EQ(tables("complete.json", "--format json"), 0);
  EXPECT_EQ(out_, files.at("tables.json"));
  EXPECT_EQ(tables("complete.json", "--table table1_klu --format json"), 0);
  const Json table = Json::parse(out_)["sections"][0]["tables"][0];
  EXPECT_EQ(table["name"], "table1_klu");
  EXPECT_EQ(table["rows"][0]["coordinates"], "114");
  EXPECT_TRUE(table["rows"][0]["TS-G_klu"]["seconds"].is_number()) << table;
}

/// A history of one candidate.
std::string history(const std::vector<Json>& instructions) {
  Json json{{"schema", 1}, {"cells", {"a"}}};
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
}

TEST_F(Program, WritesEveryFormatTwiceTheSame) {
  const fs::path first = folder_ / "a/deep", second = folder_ / "b";
  EXPECT_EQ(tables("complete.json", "--out " + first.string()), 0);
  const std::string printed = out_;
  EXPECT_EQ(tables("complete.json", "--out " + second.string()), 0);
  EXPECT_EQ(out_, printed);
  EXPECT_LE(std::ranges::count(printed, '\n'), 60);
  const auto files = files_in(first);
  EXPECT_EQ(files, files_in(second));
  for (const char* name :
       {"tables.txt", "tables.md", "report.html", "table1_cholmod.csv", "table2_klu.csv",
        "figure5.vl.json", "figure6.vl.json", "figure6.csv", "best.csv", "provenance.csv"})
    EXPECT_EQ(files.count(name), 1u) << name;
  EXPECT_EQ(tables("complete.json", "--all"), 0);
  EXPECT_EQ(files.at("tables.txt"), out_);
  EXPECT_EQ(tables("complete.json", "--out " + first.string()), 0);  // over what is there
  EXPECT_EQ(files, files_in(first));
}

TEST_F(Program, TheOrderOfCellsDoesNotMatter) {
  Json json = complete_record();
  std::reverse(json["paper"]["cells"].begin(), json["paper"]["cells"].end());
  EXPECT_EQ(tables("complete.json"), 0);
  const std::string printed = out_;
  EXPECT_EQ(tables(write("reversed.json", json.dump())), 0);
  EXPECT_EQ(out_, printed);
}

TEST_F(Program, WritesOnlyTheChosenFormats) {
  EXPECT_EQ(tables("complete.json", "--format markdown --out " + (folder_ / "out").string()), 0);
  EXPECT_EQ(files_in(folder_ / "out").count("tables.md"), 1u);
  EXPECT_EQ(files_in(folder_ / "out").count("tables.txt"), 0u);
}

/// The newest record as another machine would have made it.
std::string of_other_machine(const std::string& other) {
  const Json record = origins_record();
  return replaced(record.dump(), record["record"]["machine"]["cpu"], other);
}

TEST_F(Program, ShowsSpeedUpsBesideThoseOfOtherMachines) {
  const std::string alone = (folder_ / "alone").string(), both = (folder_ / "both").string(),
                    title = "Speed-ups here and on other machines";
  Json changed = Json::parse(of_other_machine("Other CPU"));
  const std::string own = data_file(origins).string(), other = write("other.json", changed.dump()),
                    third = write("third.json", of_other_machine("Third CPU"));
  erase_candidate(changed, truck, 114, "group_symbolic_klu");
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
  write("results/history.json", R"({"schema": 2})");
  fs::remove_all(out);
  EXPECT_EQ(report(command), 65);
  EXPECT_CONTAINS(err_, "history.json: /schema: only schema 1 is read");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Program, ReadsANewerMinorVersionWithANote) {
  Json json = complete_record();
  json["schema_version"] = "2.2.0";
  const std::string file = write("newer.json", json.dump());
  EXPECT_EQ(tables(file, "--table best --format csv"), 0);
  EXPECT_EQ(err_, "desmo_report: note: " + file +
                      ": The file has schema version 2.2.0, this program knows 2.1.0: what the "
                      "newer version adds is not shown.\n");
}

TEST_F(Program, FullDiskLeavesNothingBehind) {
  const fs::path out = folder_ / "out";
  ASSERT_EQ(tables("complete.json", "--format csv --out " + out.string()), 0);
  const auto before = files_in(out);
  // No file may grow beyond 8 blocks: the write fails half-way, as on a full disk.
  EXPECT_EQ(shell("sh -c 'trap \"\" XFSZ; ulimit -f 8; exec " + std::string(DESMO_REPORT_PROGRAM) +
                  " tables " + data_file("complete.json").string() + " --out " + out.string() +
                  "' >/dev/null"),
            74);
  EXPECT_CONTAINS(err_, "cannot be written");
  EXPECT_CONTAINS(err_, out.string());
  EXPECT_EQ(files_in(out), before);
}

TEST_F(Program, WithoutNodeTheMissingFiguresAreNamed) {
  const fs::path out = folder_ / "out";
  ASSERT_EQ(tables("complete.json", "--out " + out.string()), 0);
  const std::string render = "PATH=/nowhere /bin/sh " + std::string(DESMO_REPORT_RENDER) + " ";
  EXPECT_EQ(shell(render + out.string() + " " + (folder_ / "work").string()), 0);
  EXPECT_TRUE(
      out_.starts_with("missing figure: figure5.svg (Node.js is not installed)\n"
                       "missing figure: figure6.svg (Node.js is not installed)\n"));
  for (const char* name : {"figure5", "figure6"})
    EXPECT_CONTAINS(files_in(out)["report.html"], std::string("Missing figure: ") + name);
  EXPECT_EQ(shell(render + (folder_ / "no_such").string()), 64);
}

// In one line, with a space between words.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

// A page's text between its comments <!-- measured: RECORD --> and <!-- end of measured -->.
struct Quotation {
  std::string record, text;
};

std::vector<Quotation> quotations(const std::string& page) {
  const std::string mark = "<!-- measured: ", end_mark = "<!-- end of measured -->";
  std::vector<Quotation> found;
  for (std::size_t at = 0; (at = page.find(mark, at)) != std::string::npos;) {
    const std::size_t path = at + mark.size(), text = page.find(" -->", path) + 4,
                      end = page.find(end_mark, text);
    EXPECT_NE(end, std::string::npos) << page.substr(at, 80);
    if (end == std::string::npos) break;
    found.push_back({page.substr(path, text - 4 - path), page.substr(text, end - text)});
    at = end;
  }
  return found;
}

// Pages quote records: each line of their tables is a line of that record's report, and what they
// quote with ">" is what stands in front of it.
TEST_F(Program, PagesQuoteTheirRecords) {
  struct Page {
    const char* name;
    std::size_t records, rows;  // quoted; rows at least
  };
  const fs::path source = DESMO_SOURCE_DIR;
  for (const Page& page : {Page{"README.md", 4, 20}, Page{"formulations/accuracy.md", 1, 9}}) {
    const std::vector<Quotation> quoted = quotations(read_text(source / page.name));
    EXPECT_EQ(quoted.size(), page.records) << page.name;
    std::size_t rows = 0;
    for (const auto& [record, text] : quoted) {
      ASSERT_EQ(tables(source / record, "--format markdown"), 0);
      const std::string report = out_;
      std::string sentences;
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(">")) sentences += line.substr(1) + "\n";
        if (!line.starts_with("|")) continue;
        ++rows;
        EXPECT_CONTAINS(report, "\n" + line + "\n") << page.name << ": " << line;
      }
      ASSERT_EQ(tables(source / record), 0);
      EXPECT_CONTAINS(in_one_line(out_), in_one_line(sentences)) << page.name << ": " << sentences;
    }
    EXPECT_GE(rows, page.rows) << page.name;
  }
}

// The front page stays one that is read in minutes: at most 750 words outside tables and code, and
// three short tables of results.
TEST_F(Program, TheFrontPageIsShort) {
  std::istringstream lines(read_text(fs::path(DESMO_SOURCE_DIR) / "README.md"));
  std::size_t tables = 0, rows = 0;
  bool measured = false, code = false;
  std::string words;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("<!-- ")) measured = line.starts_with("<!-- measured: ");
    const bool fence = line.starts_with("```"), row = line.starts_with("|");
    if (fence) code = !code;
    if (!row) rows = 0;
    if (!row && !code && !fence && !line.starts_with("    ") && !line.starts_with("<!--"))
      words += line + "\n";
    if (!row || !measured) continue;
    tables += rows++ == 0;
    EXPECT_LE(rows, 12u) << line;  // ten, the header and the line below it
  }
  EXPECT_EQ(tables, 3u);
  const std::string text = in_one_line(words);
  EXPECT_LT(std::ranges::count(text, ' '), 750);
  for (std::istringstream stream(text); stream >> words;)
    EXPECT_TRUE(words.size() <= 40 || words.find("](") != std::string::npos ||
                words.find("http") == 0)
        << words << " belongs in a table or in code";
}

}  // namespace
}  // namespace desmo::report::program_test
