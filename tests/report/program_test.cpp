// desmo_report and the render script as a user runs them: exit codes, messages, files.
#include "tests/report/program.h"

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
  fail_candidate(failed, 114, "group_symbolic_klu");
  const std::string complete = "tables " + whole.string() + " ",
                    data = "tables " + data_file("").string(), file = write("file", "in the way"),
                    failing = write("failed.json", failed.dump()),
                    truncated = write("truncated.json", read_text(whole).substr(0, 28669)),
                    major = later_version(1, 0, 0),
                    unknown = write("unknown_version.json",
                                    changed(complete_record(), "/schema_version", major).dump());
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
           {"tables " + truncated, 65, "truncated.json: line 135, column 225: "},
           {"tables " + unknown + " --out " + (folder_ / "out").string(), 65,
            "unknown_version.json: /schema_version: schema version " + major +
                ", and this program reads " + versions_read()},
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

TEST_F(Program, ReadsANewerMinorVersionWithANote) {
  Json json = complete_record();
  const std::string minor = later_version(0, 2, 0);
  json["schema_version"] = minor;
  const std::string file = write("newer.json", json.dump());
  EXPECT_EQ(tables(file, "--table best --format csv"), 0);
  EXPECT_EQ(err_, "desmo_report: note: " + file + ": The file has schema version " + minor +
                      ", this program knows " + schema_version +
                      ": what the newer version adds is not shown.\n");
}

TEST_F(Program, FullDiskLeavesNothingBehind) {
  const fs::path out = folder_ / "out";
  ASSERT_EQ(tables("complete.json", "--format csv --out " + out.string()), 0);
  const auto before = files_in(out);
  EXPECT_TRUE(before.contains("best.csv") && !before.contains("tables.txt")) << "of one format";
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

}  // namespace
}  // namespace desmo::report::program_test
