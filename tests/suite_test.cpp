// desmo_bench: options, verification, and what it does when a formulation is wrong.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "bench/suite/cell.h"
#include "bench/suite/options.h"
#include "bench/suite/verification.h"

namespace desmo::suite {
namespace {

Options parse(std::vector<std::string> texts, std::vector<std::string>* rest = nullptr) {
  std::vector<char*> arguments;
  for (std::string& t : texts) arguments.push_back(t.data());
  const Options o = take_options(arguments);
  if (rest) rest->assign(arguments.begin(), arguments.end());
  return o;
}

TEST(BenchOptions, TakeTheirOwnAndLeaveTheRest) {
  std::vector<std::string> rest;
  const Options o = parse({"x", "--step=0.02", "--benchmark_filter=a", "--duration", "3",
                           "--record=out.json", "--dense-limit=9"},
                          &rest);
  EXPECT_EQ(o.step, 0.02);
  EXPECT_EQ(o.duration, 3);
  EXPECT_EQ(o.dense_limit, 9);
  EXPECT_EQ(o.record, "out.json");
  EXPECT_EQ(rest, (std::vector<std::string>{"x", "--benchmark_filter=a"}));
}

TEST(BenchOptions, RefuseWhatIsNotAPositiveNumber) {
  for (const char* bad : {"--step=0", "--step=-1", "--step=nan", "--step=inf", "--step=1x",
                          "--step=", "--dense-limit=2.5", "--duration=1e999"})
    EXPECT_THROW(parse({"x", bad}), std::invalid_argument) << bad;
  EXPECT_THROW(parse({"x", "--record"}), std::invalid_argument);
}

struct Verification : testing::Test {
  std::vector<ReferenceInstant> reference{{0, {1, 2}, {3, 4}, {5, 6}}, {1, {1, 2}, {3, 4}, {5, 6}}};
  VerifyingSink sink{reference};

  void accept(int index, double time, std::vector<double> q) {
    const std::vector<double> qd{3, 4}, qdd{5, 6};
    sink.accept({index, time, q, qd, qdd});
  }
};

TEST_F(Verification, AcceptsWhatAgrees) {
  accept(0, 0, {1, 2});
  accept(1, 0.5, {7, 7});  // the reference has nothing to say here
  accept(2, 1, {1, 2 + 1e-10});
  EXPECT_EQ(complaint(sink.errors(), 2), "");
  EXPECT_NEAR(sink.errors().position, 1e-10, 1e-15);
}

TEST_F(Verification, RefusesWhatDiffers) {
  accept(0, 0, {1, 2});
  accept(1, 1, {1, 2 + 1e-8});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsNotANumber) {
  accept(0, 0, {1, NAN});
  accept(1, 1, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsMissing) {
  accept(0, 0, {});
  accept(1, 1, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesInstantsThatWereNeverSeen) {
  accept(0, 0, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST(Cells, AreVerifiedBeforeTheyAreTimed) {
  Options o;
  o.duration = 0.5;
  ReferenceCache references;
  Cell cell(find_case("truck_suspension"), 114, find_variant("group_symbolic_klu"), o);
  EXPECT_EQ(cell.name(), "truck_suspension/114/group_symbolic_klu");
  cell.verify(references);
  EXPECT_EQ(cell.state, Cell::State::verified) << cell.message;
  EXPECT_EQ(cell.errors.instants, 51);
  EXPECT_TRUE(cell.analyse().ok());
}

TEST(Cells, FailWhenTheReferenceSaysOtherwise) {
  Options o;
  o.duration = 6;
  o.step = 2;  // too coarse for Newton to follow the branch
  ReferenceCache references;
  Cell cell(find_case("four_bar"), 114, find_variant("group_symbolic_klu"), o);
  cell.verify(references);
  EXPECT_EQ(cell.state, Cell::State::failed);
  EXPECT_NE(cell.message, "");
}

TEST(Cells, SayWhyDenseGlobalSolvesAreNotRun) {
  Options o;
  const Cell cell(find_case("four_bar"), 558, find_variant("global_automatic_lapack"), o);
  EXPECT_EQ(cell.state, Cell::State::not_run);
  EXPECT_NE(cell.message.find("O(n^3)"), std::string::npos);
}

int run_bench(const std::string& flags) {
  const int status = std::system((DESMO_BENCH " " + flags + " >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Bench, ExitCodesSayWhatHappened) {
  const std::string record = testing::TempDir() + "desmo_record.json";
  const std::string one = " --benchmark_filter=four_bar/114/group_symbolic_klu$";
  std::filesystem::remove(record);
  EXPECT_EQ(run_bench("--duration=0.2 --record=" + record + one), 0);
  std::ifstream in(record);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("\"status\": \"ok\""), std::string::npos);
  EXPECT_NE(text.find("\"cpu_seconds\""), std::string::npos);

  EXPECT_EQ(run_bench("--step=2 --record=" + record + one), 1);
  std::ifstream again(record);
  const std::string failed{std::istreambuf_iterator<char>(again), {}};
  EXPECT_NE(failed.find("\"status\": \"failed\""), std::string::npos);
  EXPECT_EQ(failed.find("\"cpu_seconds\""), std::string::npos);

  EXPECT_EQ(run_bench("--benchmark_filter=nothing_of_that_name"), 64);
  EXPECT_EQ(run_bench("--benchmark_list_tests"), 0);
  EXPECT_EQ(run_bench("--benchmark_report_aggregates_only" + one), 64);
  EXPECT_EQ(run_bench("--step=zero"), 64);
  EXPECT_EQ(run_bench("--no_such_flag"), 64);
  EXPECT_EQ(run_bench("--duration=0.2 --record=/nonexistent/record.json" + one), 74);
  EXPECT_FALSE(std::filesystem::exists(record + ".unfinished"));
  EXPECT_EQ(run_bench("--duration=0.2 --record=/dev/null" + one), 0);
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
}

TEST(Bench, RecordsAreReadByTheReport) {
  const std::string record = testing::TempDir() + "desmo_end_to_end.json";
  const std::string report = DESMO_REPORT " tables " + record + " >/dev/null 2>&1";
  // With a cell that is not run, and with one that fails.
  ASSERT_EQ(run_bench("--duration=0.02 --record=" + record +
                      " '--benchmark_filter=/(114|225)/global_automatic_(klu|lapack)$'"),
            0);
  EXPECT_EQ(std::system(report.c_str()), 0);
  ASSERT_EQ(run_bench("--step=2 --record=" + record +
                      " --benchmark_filter=four_bar/114/group_symbolic_klu"),
            1);
  EXPECT_EQ(std::system(report.c_str()), 0);
  std::filesystem::remove(record);
}

}  // namespace
}  // namespace desmo::suite
