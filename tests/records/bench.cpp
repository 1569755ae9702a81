// desmo_bench as a program: experiments, exit codes, records, settings.

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/started.h"

namespace desmo::bench::bench_program_test {
namespace {

/// environment: settings of variables, for the shell.
int run_bench(const std::string& flags, const std::string& environment = "") {
  return run(environment + " " DESMO_BENCH " " + flags).code;
}

/// Iterations for steps of 2 s.
const std::string too_few =
    " --formulation=group_symbolic_klu/iterations:1"
    " --benchmark_filter=four_bar/114/group_symbolic_klu/iterations:1";

using Bench = InFolder;

TEST_F(Bench, ExitCodesSayWhatHappened) {
  const std::string record = file("record.json");
  const std::string one = " --benchmark_filter=four_bar/114/group_symbolic_klu$";
  EXPECT_EQ(run_bench("--duration=0.2 --record=" + record + one), 0);
  const std::string text = text_of(record);
  EXPECT_CONTAINS(text, "\"status\":\"ok\"");
  for (const char* key : {"schema_version", "time", "clock", "seconds", "machine", "model",
                          "results", "turbo", "link", "binary", "windows", "updates", "samples"})
    EXPECT_CONTAINS(text, "\"" + std::string(key) + "\"") << key;

  EXPECT_EQ(run_bench("--step=2 --record=" + record + too_few), 1);
  const std::string failed = text_of(record);
  EXPECT_CONTAINS(failed, "\"status\":\"failed\"");
  EXPECT_LACKS(failed, "\"time\"");

  EXPECT_EQ(run_bench("--benchmark_filter=nothing_of_that_name"), 64);
  EXPECT_EQ(run_bench("--benchmark_list_tests" + one), 0);
  EXPECT_EQ(run_bench("--benchmark_report_aggregates_only" + one), 64);
  EXPECT_EQ(run_bench("--step=zero"), 64);
  for (const char* setting : {"guess:cubic", "scalar:float"})
    EXPECT_EQ(run_bench("--formulation=group_automatic_klu/" + std::string(setting)), 64);
  EXPECT_EQ(run_bench("--no_such_flag"), 64);
  EXPECT_EQ(run_bench("--duration=0.2 --record=/nonexistent/record.json" + one), 74);
  EXPECT_FALSE(std::filesystem::exists(record + ".unfinished"));
  EXPECT_EQ(run_bench("--duration=0.2 --record=/dev/null" + one), 0);
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
}

/// Returns what the program writes to standard output and standard error.
std::string said(const std::string& arguments) { return run(DESMO_BENCH " " + arguments).text; }

TEST_F(Bench, HasEveryExperimentByItsName) {
  EXPECT_TRUE(said("--version").starts_with("desmo_bench 0."));
  EXPECT_EQ(run_bench(""), 0);
  const std::string help = said("");
  EXPECT_CONTAINS(said("--help"), help);
  for (const char* name : {"paper", "accuracy", "size", "instructions", "extremes", "modelling"}) {
    EXPECT_CONTAINS(help, "\n  " + std::string(name) + " ") << name;
    const std::string options = said(name + std::string(" --help"));
    for (const char* common : {"--record FILE", "--quick", "--filter REGEX"})
      EXPECT_CONTAINS(options, common) << name << ' ' << common;
    EXPECT_EQ(run_bench(name + std::string(" --no_such_flag")), 64) << name;
    const std::string brief = name + std::string(" --quick --record /dev/null ") +
                              (name == std::string("extremes") ? "--row 14" : "");
    for (const char* filter : {" --filter no_such_formulation", " --filter '('"})
      EXPECT_EQ(run_bench(brief + filter), 64) << name << filter;
  }
  EXPECT_EQ(run_bench("precision --quick"), 64);
  EXPECT_CONTAINS(said("precision"),
                  "unknown experiment 'precision'; there are 'paper', 'accuracy'");
  EXPECT_CONTAINS(said("size --bodies"), "not expected: --bodies");
  EXPECT_CONTAINS(said("accuracy four_bar/114"), "not expected: four_bar/114");
  EXPECT_CONTAINS(said("accuracy --quick"), "--record FILE is missing");
}

TEST_F(Bench, NamesTheProgramThatAnExperimentNeeds) {
  std::filesystem::copy_file(DESMO_BENCH, file("desmo_bench"));
  const Ended alone = run(file("desmo_bench") + " extremes --quick --record /dev/null");
  EXPECT_EQ(alone.code, 74);
  EXPECT_CONTAINS(alone.text, "/desmo_bench_all cannot be started; bench/run builds it");
}

/// Lines that are no progress of the program.
long lines_of(const std::string& text) {
  std::istringstream in(text);
  long lines = 0;
  for (std::string line; std::getline(in, line);) lines += !line.starts_with("benchmarks: ");
  return lines;
}

TEST_F(Bench, ShowsEveryBenchmarkOnlyWhereAsked) {
  // The residual of one of them is always 0, and has no spread; one is not run.
  const std::string some =
      "--duration=0.02 --repetitions=2 "
      "'--filter=four_bar/225/(group_symbolic_(klu|explicit)|global_automatic_lapack)$'";
  const std::string with_record = said(some + " --record=/dev/null");
  EXPECT_EQ(lines_of(with_record), 0) << with_record;
  EXPECT_TRUE(with_record.starts_with("benchmarks: 100 % in ")) << with_record;

  for (const std::string& with_table : {said(some + " --record=/dev/null --table"), said(some)}) {
    for (const char* shown : {"\nfour_bar/225/group_symbolic_klu_median ", "iterations/step",
                              "four_bar/225/global_automatic_lapack: a dense global solve"})
      EXPECT_CONTAINS(with_table, shown) << shown << '\n' << with_table;
    for (const char* noise : {"nan", "DEBUG"}) EXPECT_LACKS(with_table, noise);
  }
  const std::string warning = "desmo_bench: without --record nothing of this will be kept\n";
  EXPECT_TRUE(said(some).starts_with(warning));
  EXPECT_LACKS(with_record, "will be kept");
  EXPECT_LACKS(said("--benchmark_list_tests"), "will be kept");

  const std::string failing = said("--step=2 --record=/dev/null" + too_few);
  EXPECT_EQ(lines_of(failing), 1) << failing;
  EXPECT_CONTAINS(failing, "four_bar/114/group_symbolic_klu/iterations:1: ");
}

TEST_F(Bench, RecordsAreReadByTheReport) {
  const std::string record = file("record.json");
  const std::string report = DESMO_REPORT " tables " + record;
  // Records with a candidate that is not run, and with one that fails
  ASSERT_EQ(run_bench("--duration=0.02 --record=" + record +
                      " '--benchmark_filter=/(114|225)/global_automatic_(klu|lapack)$'"),
            0);
  EXPECT_EQ(run(report).code, 0);
  const std::string text = text_of(record);
  for (const char* of : {"four_bar\",\"coordinates\":114", "four_bar\",\"coordinates\":225",
                         "truck_suspension\",\"coordinates\":225"})
    EXPECT_CONTAINS(text, "{\"case\":\"" + std::string(of)) << of;
  ASSERT_EQ(run_bench("--step=2 --record=" + record + too_few), 1);
  EXPECT_EQ(run(report).code, 0);
  // A record of requests alone
  ASSERT_EQ(run_bench("--duration=0.02 --record=" + record +
                      " '--benchmark_filter=request:(damper|axle)$'"),
            0);
  EXPECT_CONTAINS(run(report + " --all").text, "What a request costs");
}

// The record has a peer, a request with the whole it is part of, and several threads with one.
TEST_F(Bench, RecordsOfAllKindsAreReadByTheReport) {
  const std::string record = file("record.json");
  ASSERT_EQ(
      run_bench("--duration=0.2 --benchmark_repetitions=3 --record=" + record +
                " '--benchmark_filter=truck_suspension/558/(peer:tree$|global_automatic_klu"
                "(/request:outputs)?$|group_symbolic_explicit/guess:adams8/segments:4/.*(threads|"
                "clock))'"),
      0);
  const std::string text = text_of(record);
  for (const char* part :
       {"\"peers\": [", "\"requests\": [", "\"threads\":2", "\"clock\":\"cpu\"", "/clock:wall\""})
    EXPECT_CONTAINS(text, part);
  nlohmann::json written = nlohmann::json::parse(text);
  for (auto& candidate : written["paper"]["candidates"]) {
    const bool by_wall_clock = candidate["id"].get<std::string>().find("/segments:4/") != text.npos;
    EXPECT_EQ(candidate["time"]["clock"], by_wall_clock ? "wall" : "cpu") << candidate["id"];
    EXPECT_NE(candidate["time"].contains("windows"), by_wall_clock) << candidate["id"];
  }
  const Ended report = run(DESMO_REPORT " tables " + record + " --all");
  EXPECT_EQ(report.code, 0);
  EXPECT_CONTAINS(report.text, "What a request costs");
  EXPECT_LACKS(report.text, "one thread not measured");
}

TEST_F(Bench, TimesThePapersSolverWhereItsLibraryIs) {
  const std::string record = file("record.json");
  const std::string flags =
      "--duration=0.02 --record=" + record +
      " '--benchmark_filter=truck_suspension/114/(global_automatic|group_symbolic)_(ma27|klu)$'";
  ASSERT_EQ(run_bench(flags, "DESMO_LIBCOINHSL=" DESMO_MA27_DOUBLE), 0);
  const std::string text = text_of(record);
  const std::string library = std::filesystem::path(DESMO_MA27_DOUBLE).filename().string();
  for (const std::string& part :
       {"\"" + library + " 1.2.3\"", std::string("\"id\":\"global_automatic_ma27\""),
        std::string("\"id\":\"group_symbolic_ma27\"")})
    EXPECT_CONTAINS(text, part) << part;
  EXPECT_LACKS(text, "\"status\":\"failed\"");
  EXPECT_EQ(run(DESMO_REPORT " tables " + record).code, 0);

  EXPECT_EQ(run_bench("--formulation=group_automatic_ma27/guess:linear",
                      "DESMO_LIBCOINHSL=" DESMO_MA27_INCOMPLETE),
            64);
}

}  // namespace
}  // namespace desmo::bench::bench_program_test
