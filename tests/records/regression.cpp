// Programs of bench/check: the candidates of the probe, the driver, and counts that repeat.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/kit/candidate_name.h"
#include "bench/regression/measured_candidates.h"
#include "bench/regression/rounds.h"
#include "bench/regression/stepped_formulation.h"
#include "formulations/algebra/backend.h"
#include "formulations/variants.h"
#include "report/check/check_record.h"
#include "results/schema_version.h"
#include "tests/started.h"

namespace desmo::regression::regression_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(CandidateNames, AreReadOrRefused) {
  const bench::CandidateName name = bench::parse_name("four_bar/24/group_symbolic_klu");
  EXPECT_EQ(name.case_name, "four_bar");
  EXPECT_EQ(name.coordinates, 24);
  EXPECT_EQ(name.id, "group_symbolic_klu");
  EXPECT_EQ(name.text(), "four_bar/24/group_symbolic_klu");
  for (const char* bad : {"", "four_bar", "four_bar/24", "four_bar/24/", "four_bar/x/id", "a//b"})
    EXPECT_THROW(bench::parse_name(bad), std::invalid_argument) << bad;
}

TEST(Control, HasTheNameThatTheReportReads) { EXPECT_STREQ(control_name, report::control_name); }

TEST(MeasuredCandidates, UsesEveryPartitionEvaluationAndAlgebraOfThisBuild) {
  std::string ids;
  for (const std::string& name : measured_candidates()) ids += bench::parse_name(name).id + ' ';
  for (const Variant& v : variants()) {
    if (const auto* b = find_backend(v.algebra); b && b->absence)
      continue;  // on some machines only
    const std::size_t evaluation = v.id.find('_'), algebra = v.id.rfind('_');
    EXPECT_CONTAINS(ids, v.id.substr(0, evaluation + 1));
    EXPECT_CONTAINS(ids, v.id.substr(evaluation, algebra + 1 - evaluation));
    EXPECT_CONTAINS(ids, v.id.substr(algebra) + ' ');
  }
}

TEST(SteppedFormulation, WalksBackAndForthToTheSameSolution) {
  const char* id = "group_symbolic_klu";
  const bench::Problem problem = problem_of({"four_bar", 24, id}, 21);
  SteppedFormulation stepped(problem, id);
  ASSERT_TRUE(stepped.run().ok());
  const Summary back = stepped.walk(19, 10);
  ASSERT_TRUE(back.ok());
  EXPECT_DOUBLE_EQ(back.time, 0.1);
  EXPECT_LT(back.residual, Settings{}.tolerance);
  EXPECT_TRUE(stepped.walk(11, 20).ok());
}

TEST(SteppedFormulation, ExtraStepsAreTheShareAskedFor) {
  EXPECT_EQ(extra_steps(100, 1), 1);
  EXPECT_EQ(extra_steps(100, 10), 10);
  EXPECT_EQ(extra_steps(50, 10), 5);
  EXPECT_EQ(extra_steps(50, 0), 0);
}

class Driver : public InFolder {
 protected:
  int check(const std::string& arguments) {
    return shell(std::string(DESMO_CHECK) + " --base " + programs + " --head " + programs + " " +
                 arguments);
  }
  int verdict(const std::string& options = "") {
    return shell(std::string(DESMO_REPORT) + " check " + file("results.json") + " " + options);
  }
  std::string text(const std::string& name) const { return text_of(folder_ / name); }
  Json results() const { return Json::parse(text("results.json")); }

  bool can_count() { return shell("valgrind --version") == 0; }

  const std::string programs = fs::path(DESMO_CHECK).parent_path().string();
  const std::string name = "four_bar/54/block_symbolic_klu";
};

TEST_F(Driver, CountsRepeatToTheLastInstruction) {
  if (!can_count()) GTEST_SKIP() << "needs valgrind";
  std::vector<Json> counts;
  for (int run = 0; run < 2; ++run) {
    ASSERT_EQ(check("measure " + file("results.json") + " --no-time --candidate " + name), 0)
        << err_;
    EXPECT_EQ(verdict(), 0) << out_;
    const Json both = results()["work"]["instructions"][name];
    counts.push_back(both["base"]);
    counts.push_back(both["head"]);
  }
  EXPECT_GT(counts[0], 1'000'000);
  for (const Json& count : counts) EXPECT_EQ(count, counts[0]);
}

TEST_F(Driver, OnePercentMoreInstructionsRaiseAnAlarm) {
  if (!can_count()) GTEST_SKIP() << "needs valgrind";
  ASSERT_EQ(check("measure " + file("results.json") + " --no-time --candidate " + name +
                  " --slow head:" + name + ":1"),
            0)
      << err_;
  EXPECT_EQ(verdict(), 1) << out_;
  EXPECT_CONTAINS(out_, "More work: " + name);
}

TEST_F(Driver, HistoryHasAPointForEachCommitInTheirOrder) {
  if (!can_count()) GTEST_SKIP() << "needs valgrind";
  const auto add = [&](const std::string& commit, const std::string& date,
                       const std::string& more) {
    return shell(std::string(DESMO_CHECK) + " --head " + programs + " history " +
                 file("history.json") + " --commit=" + commit + " --date=" + date +
                 " --subject='-\"" + commit + "\"' " + more);
  };
  const std::string lacking = "four_bar/54/group_of_the_future",
                    other = "four_bar/24/" + name.substr(12);
  ASSERT_EQ(add("a", "2026-01-01T00:00:00Z", name), 0) << err_;
  ASSERT_EQ(add("c", "2026-03-01T00:00:00Z", name + " " + lacking), 0) << err_;
  ASSERT_EQ(add("b", "2026-02-01T00:00:00Z", name + " " + other), 0) << err_;
  const Json history = Json::parse(text("history.json"));
  EXPECT_EQ(history["schema"], 2);
  EXPECT_EQ(history["candidates"], (Json{name, lacking, other}));
  std::string order;
  for (const Json& point : history["points"]) order += point["commit"].get<std::string>();
  EXPECT_EQ(order, "abc");
  const Json &a = history["points"][0], &b = history["points"][1], &c = history["points"][2];
  EXPECT_EQ(a["subject"], "-\"a\"");
  EXPECT_EQ(a["compiler"].get<std::string>().substr(0, 4), "GNU ");
  EXPECT_GT(a["instructions"][0], 1'000'000);
  EXPECT_EQ(c["instructions"], (Json{a["instructions"][0], nullptr, nullptr}));
  EXPECT_TRUE(a["instructions"][2].is_null());
  EXPECT_GT(b["instructions"][2], 100'000);
  ASSERT_EQ(add("e", "2026-05-01T00:00:00Z", lacking), 0) << err_;
  EXPECT_LACKS(err_, "nan %");  // there is nothing to count

  const std::string before = text("history.json");
  EXPECT_EQ(shell(std::string(DESMO_CHECK) + " --head " + file("nowhere") + " history " +
                  file("history.json") + " --commit=d --date=2026 --subject=d " + name),
            74);
  EXPECT_EQ(text("history.json"), before);
  write("history.json", R"({"schema": "desmo-check"})");
  EXPECT_EQ(add("d", "2026", name), 74);
  EXPECT_EQ(text("history.json"), R"({"schema": "desmo-check"})");
}

// Measured code is compiled without line numbers: another line of comment gives the same object.
TEST_F(Driver, ACommentChangesNoInstruction) {
  const std::string source = DESMO_SOURCE_DIR "/formulations/parts/inlined_part.cpp";
  write("plain.cpp", text_of(source));
  write("commented.cpp", "// One more line.\n" + text_of(source));
  // Any file of the library stands for its flags: sources may be compiled several at once.
  for (const Json& entry : Json::parse(std::ifstream(DESMO_BUILD_DIR "/compile_commands.json"))) {
    const std::string command = entry["command"], folder = entry["directory"];
    if (command.find("/desmo_formulations.dir/") == std::string::npos) continue;
    const std::string compile = command.substr(0, command.find(" -o "));
    std::vector<std::string> objects;
    for (const std::string name : {"plain", "commented"}) {
      ASSERT_EQ(shell("cd " + folder + " && cp " + file(name + ".cpp") + " " + file("part.cpp") +
                      " && " + compile + " -o " + file("part.o") + " -c " + file("part.cpp")),
                0)
          << err_;
      objects.push_back(text("part.o"));
    }
    EXPECT_GT(objects[0].size(), 1000u);
    EXPECT_EQ(objects[0], objects[1]);
    return;
  }
  FAIL() << "no command that compiles a file of desmo_formulations was found";
}

TEST_F(Driver, TimesAreMeasuredInPairsAndMoreCanBeAdded) {
  ASSERT_EQ(check("measure " + file("results.json") + " --no-work --candidate " + name), 0) << err_;
  EXPECT_CONTAINS(err_, "rounds of 1 candidates");
  EXPECT_LE(verdict(), 3) << out_;
  EXPECT_EQ(results()["head"]["paper"]["candidates"][0]["time"]["seconds"].size(), 25u);
  EXPECT_EQ(results()["control"]["base"].size(), 25u);
  ASSERT_EQ(check("more " + file("results.json") + " first " + name), 0) << err_;
  ASSERT_EQ(check("more " + file("results.json") + " second " + name), 0) << err_;
  const Json json = results();
  for (const char* side : {"base", "head"}) {
    EXPECT_EQ(json[side]["paper"]["candidates"][0]["time"]["seconds"].size(), 50u);
    EXPECT_EQ(json["control"][side].size(), 50u);
    EXPECT_EQ(json["second"][name][side].size(), 25u);
    EXPECT_EQ(json["second"]["control"][side].size(), 25u);
  }
  EXPECT_NE(json["base"]["paper"]["candidates"][0]["time"],
            json["head"]["paper"]["candidates"][0]["time"]);
  EXPECT_LE(verdict(), 3) << err_;
}

/// Trees before schema 3 write other words.
TEST_F(Driver, ComparesWithATreeOfSchema2) {
  fs::create_directory(file("older"));
  write("older/desmo_probe", "#!/bin/sh\n" + programs + "/desmo_probe \"$@\" | sed " +
                                 "'s/\"candidates\"/\"cells\"/; s/\"" + schema_version +
                                 "\"/\"2.0.0\"/'\n");
  fs::permissions(file("older/desmo_probe"), fs::perms::owner_all);
  ASSERT_EQ(shell(file("older/desmo_probe") + " verify 3 " + name), 0) << err_;
  EXPECT_CONTAINS(out_, "\"cells\"");
  ASSERT_EQ(shell(std::string(DESMO_CHECK) + " --base " + file("older") + " --head " + programs +
                  " measure " + file("results.json") + " --no-work --no-time --candidate " + name),
            0)
      << err_;
  for (const char* side : {"base", "head"}) {
    EXPECT_EQ(results()[side]["schema_version"], schema_version) << side;
    EXPECT_EQ(results()[side]["paper"]["candidates"].size(), 1u) << side;
  }
}

TEST_F(Driver, ErrorsNameWhatIsWrongAndLeaveNoFile) {
  EXPECT_EQ(check("measure " + file("results.json") + " --slow head:no/1/such:5"), 64);
  EXPECT_CONTAINS(err_, "no/1/such");
  EXPECT_EQ(check("measure " + file("results.json") + " --slow sideways:" + name + ":5"), 64);
  EXPECT_EQ(check("measure " + file("results.json") + " --slow head:" + name + ":much"), 64);
  EXPECT_EQ(check("measure " + file("results.json") + " --candidate no/1/such"), 64);
  const std::string alone =
      std::string(DESMO_CHECK) + " --head " + file("nowhere") + " measure " + file("results.json");
  EXPECT_EQ(shell(alone), 64);
  EXPECT_CONTAINS(err_, "times need --base");
  EXPECT_EQ(shell(alone + " --no-time"), 74);
  EXPECT_CONTAINS(err_, file("nowhere"));
  EXPECT_EQ(check("more " + file("results.json") + " first " + name), 74);
  EXPECT_EQ(check("measure " + file("no/folder.json") + " --no-work --candidate " + name), 74);
  EXPECT_FALSE(fs::exists(file("results.json")));
}

}  // namespace
}  // namespace desmo::regression::regression_test
