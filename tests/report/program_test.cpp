// desmo_report and the render script as a user runs them: exit codes, messages, files.
#include "tests/report/program.h"

#include <fstream>
#include <sstream>

#include "tests/report/sample.h"

namespace desmo::report::program_test {
namespace {

namespace fs = std::filesystem;

TEST_F(Program, PrintsTheTablesAndWritesNothing) {
  EXPECT_EQ(tables("complete.json"), 0);
  EXPECT_NE(out_.find("Table 1 (klu)"), std::string::npos);
  EXPECT_NE(out_.find("Table 2 (umfpack)"), std::string::npos);
  EXPECT_EQ(err_, "");
}

TEST_F(Program, TellsItsVersion) {
  EXPECT_EQ(shell(std::string(DESMO_REPORT_PROGRAM) + " --version"), 0);
  EXPECT_TRUE(out_.starts_with("desmo_report 0.")) << out_;
}

TEST_F(Program, WritesEveryFormatTwiceTheSame) {
  const fs::path first = folder_ / "a/deep", second = folder_ / "b";
  EXPECT_EQ(tables("complete.json", "--out " + first.string()), 0);
  const std::string printed = out_;
  EXPECT_EQ(tables("complete.json", "--out " + second.string()), 0);
  EXPECT_EQ(out_, printed);
  const auto files = files_in(first);
  EXPECT_EQ(files, files_in(second));
  for (const char* name : {"tables.txt", "tables.json", "tables.md", "tables.tex", "report.html",
                           "table1_cholmod.csv", "table2_klu.csv", "figure5.vl.json",
                           "figure6.vl.json", "scaling.csv", "conclusion.csv", "provenance.csv"})
    EXPECT_EQ(files.count(name), 1u) << name;
  EXPECT_EQ(files.at("tables.txt"), printed);
  EXPECT_EQ(tables("complete.json", "--out " + first.string()), 0);  // over what is there
  EXPECT_EQ(files, files_in(first));
}

TEST_F(Program, TheOrderOfCellsDoesNotMatter) {
  Json json = complete_record();
  std::reverse(json["cells"].begin(), json["cells"].end());
  std::ofstream(folder_ / "reversed.json") << json.dump();
  EXPECT_EQ(tables("complete.json"), 0);
  const std::string printed = out_;
  EXPECT_EQ(tables((folder_ / "reversed.json").string()), 0);
  EXPECT_EQ(out_, printed);
}

TEST_F(Program, WritesTheTablesOfPartitionsAndRequests) {
  EXPECT_EQ(tables("structured.json", "--out " + (folder_ / "out").string()), 0);
  const auto files = files_in(folder_ / "out");
  for (const char* name :
       {"partitions.csv", "partition_times_four_bar.csv", "partition_times_truck_suspension.csv",
        "requests_truck_suspension_225.csv"})
    EXPECT_EQ(files.count(name), 1u) << name;
  for (const char* name : {"tables.txt", "tables.md", "tables.tex", "tables.json", "report.html"})
    EXPECT_NE(files.at(name).find("What a request costs"), std::string::npos) << name;
}

TEST_F(Program, WritesOnlyTheChosenFormats) {
  EXPECT_EQ(tables("complete.json", "--format markdown --out " + (folder_ / "out").string()), 0);
  EXPECT_EQ(files_in(folder_ / "out").count("tables.md"), 1u);
  EXPECT_EQ(files_in(folder_ / "out").count("tables.tex"), 0u);
  EXPECT_EQ(tables("complete.json", "--format json"), 0);
  EXPECT_EQ(Json::parse(out_)["schema"], "desmo-tables");
}

TEST_F(Program, UsageErrors) {
  EXPECT_EQ(shell(DESMO_REPORT_PROGRAM), 64);
  EXPECT_EQ(shell(std::string(DESMO_REPORT_PROGRAM) + " tables"), 64);
  EXPECT_EQ(shell(std::string(DESMO_REPORT_PROGRAM) + " chairs"), 64);
  EXPECT_EQ(tables("complete.json", "--format pdf"), 64);
  EXPECT_EQ(shell(std::string(DESMO_REPORT_PROGRAM) + " --help"), 0);
}

TEST_F(Program, InvalidRecordsNameFileAndPlace) {
  EXPECT_EQ(tables("unknown_version.json", "--out " + (folder_ / "out").string()), 65);
  EXPECT_NE(err_.find("unknown_version.json: version: schema version 2.0.0 is not supported"),
            std::string::npos)
      << err_;
  EXPECT_EQ(out_, "");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_EQ(tables("truncated.json"), 65);
  EXPECT_NE(err_.find("truncated.json: not a complete JSON document"), std::string::npos) << err_;
  EXPECT_EQ(tables("no_such.json"), 65);
  EXPECT_NE(err_.find("no_such.json: cannot be read: No such file"), std::string::npos) << err_;
}

TEST_F(Program, MarksFailuresEverywhereAndSucceeds) {
  EXPECT_EQ(tables("failed.json", "--out " + (folder_ / "out").string()), 0);
  for (const char* name : {"tables.txt", "tables.json", "tables.md", "tables.tex", "report.html",
                           "table1_klu.csv", "table2_klu.csv", "figure5.vl.json"})
    EXPECT_NE(files_in(folder_ / "out")[name].find("FAILED"), std::string::npos) << name;
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
  EXPECT_NE(err_.find("cannot be written"), std::string::npos) << err_;
  EXPECT_NE(err_.find(out.string()), std::string::npos) << err_;
  EXPECT_EQ(files_in(out), before);
}

TEST_F(Program, OutputErrorsNameTheFile) {
  std::ofstream(folder_ / "file") << "in the way";
  EXPECT_EQ(tables("complete.json", "--out " + (folder_ / "file").string()), 74);
  EXPECT_NE(err_.find((folder_ / "file").string()), std::string::npos) << err_;
  EXPECT_EQ(tables("complete.json", "--out /proc/nowhere"), 74);
  EXPECT_NE(err_.find("/proc/nowhere"), std::string::npos) << err_;
  EXPECT_EQ(tables("complete.json", ">/dev/full"), 74);
  EXPECT_NE(err_.find("standard output cannot be written"), std::string::npos) << err_;
}

TEST_F(Program, WithoutNodeTheMissingFiguresAreNamed) {
  const fs::path out = folder_ / "out";
  ASSERT_EQ(tables("complete.json", "--out " + out.string()), 0);
  const std::string render = "PATH=/nowhere /bin/sh " + std::string(DESMO_REPORT_RENDER) + " ";
  EXPECT_EQ(shell(render + out.string() + " " + (folder_ / "work").string()), 0);
  EXPECT_EQ(out_,
            "missing figure: figure5.svg (Node.js is not installed)\n"
            "missing figure: figure6.svg (Node.js is not installed)\n");
  for (const char* name : {"figure5", "figure6"})
    EXPECT_NE(files_in(out)["report.html"].find(std::string("Missing figure: ") + name),
              std::string::npos);
  EXPECT_EQ(shell(render + (folder_ / "no_such").string()), 64);
}

// What is filed of a run stays what its record gives, byte for byte, whatever later schemas add.
TEST_F(Program, EveryFiledRecordGivesTheReportBesideIt) {
  int runs = 0;
  for (const auto& entry : fs::recursive_directory_iterator(DESMO_SOURCE_DIR "/results/runs")) {
    const fs::path record = entry.path(), report = fs::path(record).replace_extension();
    if (record.extension() != ".json" || !fs::is_directory(report)) continue;
    ++runs;
    const fs::path out = folder_ / std::to_string(runs);
    ASSERT_EQ(shell(std::string(DESMO_REPORT_PROGRAM) + " tables " + record.string() + " --out " +
                    out.string()),
              0);
    std::map<std::string, std::string> filed = files_in(report);
    std::erase_if(filed, [](const auto& file) { return file.first.ends_with(".svg"); });
    filed.erase("report.html");  // with its figures too large to be filed
    std::map<std::string, std::string> given = files_in(out);
    EXPECT_EQ(given.erase("report.html"), 1u);
    EXPECT_EQ(given, filed) << record;
  }
  EXPECT_GT(runs, 0);
}

// Pages quote recorded runs: each line of their tables is a line of that run's report.
TEST_F(Program, PagesQuoteTheirRecords) {
  struct Page {
    const char* name;
    int records, rows;  // quoted; rows at least
  };
  const fs::path source = DESMO_SOURCE_DIR;
  const std::string mark = "<!-- measured: ";
  for (const Page& page : {Page{"README.md", 5, 60}, Page{"formulations/accuracy.md", 5, 80}}) {
    const std::string text = read_text(source / page.name);
    int rows = 0, records = 0;
    for (std::size_t begin = 0; (begin = text.find(mark, begin)) != std::string::npos; ++records) {
      const std::size_t path = begin + mark.size(),
                        end = text.find("<!-- end of measured -->", path);
      ASSERT_NE(end, std::string::npos) << page.name;
      const fs::path record = source / text.substr(path, text.find(" -->", path) - path);
      ASSERT_EQ(shell(std::string(DESMO_REPORT_PROGRAM) + " tables " + record.string() +
                      " --format markdown"),
                0);
      std::istringstream lines(text.substr(begin, end - begin));
      for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("|")) continue;
        ++rows;
        EXPECT_NE(out_.find("\n" + line + "\n"), std::string::npos) << page.name << ": " << line;
      }
      begin = end;
    }
    EXPECT_EQ(records, page.records) << page.name;
    EXPECT_GE(rows, page.rows) << page.name;
  }
}

}  // namespace
}  // namespace desmo::report::program_test
