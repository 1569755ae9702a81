// desmo_report check as bench/check runs it: exit codes and messages.
#include "tests/report/check/check_sample.h"
#include "tests/report/program.h"

namespace desmo::report::check_program_test {
namespace {

class CheckProgram : public Program {
 protected:
  int check(const std::string& text, const std::string& options = "") {
    return report("check " + write("results.json", text) + " " + options);
  }
};

TEST_F(CheckProgram, NamesWhatHasBecomeSlowerInMarkdownToo) {
  Json json = check_sample();
  slow_down(json, watched, 1.1);
  EXPECT_EQ(check(json.dump(), "--pending"), 0);
  EXPECT_EQ(out_, std::string("second ") + watched + "\n");
  EXPECT_EQ(check(json.dump()), 3);
  confirm(json, watched, 1.1);
  EXPECT_EQ(check(json.dump(), "--pending"), 0);
  EXPECT_EQ(out_, "");
  EXPECT_EQ(check(json.dump(), "--format markdown"), 1);
  EXPECT_CONTAINS(out_, "Slower: truck\\_suspension/114/group\\_symbolic\\_klu.");
}

TEST_F(CheckProgram, WrongNumerics) {
  Json json = check_sample();
  fail_head(json, watched);
  EXPECT_EQ(check(json.dump()), 2);
  EXPECT_CONTAINS(out_, "Wrong numerics, not timed: " + std::string(watched));
}

TEST_F(CheckProgram, FilesThatCannotBeJudgedSayWhy) {
  const std::string whole = check_sample().dump();
  EXPECT_EQ(check(whole.substr(0, whole.size() / 2)), 2);
  EXPECT_CONTAINS(err_, "results.json: line 1, column ");
  EXPECT_EQ(check("nonsense"), 2);
  Json json = check_sample();
  const std::string major = later_version(1, 0, 0), minor = later_version(0, 2, 0);
  json["schema_version"] = major;
  EXPECT_EQ(check(json.dump()), 4);
  EXPECT_CONTAINS(err_, "schema version " + major + ", and this program reads " + versions_read());
  json["schema_version"] = json["head"]["schema_version"] = minor;
  json["something_new"] = true;
  EXPECT_EQ(check(json.dump()), 0);
  EXPECT_CONTAINS(out_, "schema version " + minor + ", this program knows " + schema_version);
  json = check_sample();
  json["head"]["paper"]["candidates"][0]["machine"] = "other";
  EXPECT_EQ(check(json.dump()), 4);
  EXPECT_CONTAINS(err_, "a record is of one machine");
  EXPECT_EQ(report("check " + (folder_ / "no_such.json").string()), 64);
  EXPECT_CONTAINS(err_, "no_such.json: there is no such file");
  EXPECT_EQ(report("check"), 64);
}

TEST_F(CheckProgram, ABaselineIsReadLikeACheckAndNamedWhenItIsNone) {
  const std::string baseline = write("baseline.json", one_tree_sample().dump());
  EXPECT_EQ(check(one_tree_sample().dump(), "--baseline " + baseline), 0);
  EXPECT_CONTAINS(out_, "Verdict: PASS");
  EXPECT_EQ(err_, "");
  EXPECT_EQ(check(one_tree_sample().dump()), 4);  // alone it compares with nothing
  EXPECT_EQ(check(one_tree_sample().dump(), "--baseline " + write("bad.json", "{")), 2);
  EXPECT_CONTAINS(err_, "bad.json");
}

}  // namespace
}  // namespace desmo::report::check_program_test
