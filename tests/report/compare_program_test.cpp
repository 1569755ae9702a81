// desmo_report compare as a user runs it, and what it answers to files that are not what they seem.
#include <fstream>

#include "tests/report/program.h"
#include "tests/report/sample.h"

namespace desmo::report::compare_program_test {
namespace {

class Compare : public Program {
 protected:
  // The newest record beside a changed one.
  int compare(const std::string& text) {
    std::ofstream(folder_ / "b.json") << text;
    return report("compare " + data_file("origins.json").string() + " " +
                  (folder_ / "b.json").string());
  }
  int compare(const Json& json) { return compare(json.dump()); }

  bool complains(const std::string& what) const { return err_.find(what) != std::string::npos; }

  Json newest_ = Json::parse(read_text(data_file("origins.json")));
};

TEST_F(Compare, PrintsTheRatios) {
  EXPECT_EQ(compare(newest_), 0);
  EXPECT_NE(out_.find("A over B"), std::string::npos);
  EXPECT_NE(out_.find("damper"), std::string::npos);
  EXPECT_EQ(err_, "");
  const std::string a = data_file("origins.json").string();
  EXPECT_EQ(report("compare " + a + " " + a + " --format markdown"), 0);
  EXPECT_NE(out_.find("**CPU seconds of A and B**"), std::string::npos);
}

TEST_F(Compare, IncomparableRecordsEndWithCode4AndTheReason) {
  newest_["record"]["blas"]["core"] = "Abacus";
  EXPECT_EQ(compare(newest_), 4);
  EXPECT_TRUE(complains("cannot be compared:")) << err_;
  EXPECT_TRUE(complains("BLAS core: ")) << err_;
  EXPECT_EQ(out_, "");
}

TEST_F(Compare, TwoMachinesEndWithCode3AndWhyThereIsNoVerdict) {
  std::string text = newest_.dump();
  const std::string cpu = newest_["record"]["machine"]["cpu"], other = "Other CPU";
  for (std::size_t at = 0; (at = text.find(cpu, at)) != std::string::npos; at += other.size())
    text.replace(at, cpu.size(), other);
  EXPECT_EQ(compare(text), 3);
  EXPECT_TRUE(complains("no verdict: the records are of two machines, " + cpu + " and " + other))
      << err_;
  EXPECT_NE(out_.find("Speed-ups of two machines"), std::string::npos);
}

TEST_F(Compare, ARecordOfTwoMachinesEndsWithCode4) {
  newest_["paper"]["cells"][2]["machine"] = "Other CPU";
  EXPECT_EQ(compare(newest_), 4);
  EXPECT_TRUE(complains("b.json: ")) << err_;
  EXPECT_TRUE(complains("measured on \"Other CPU\"")) << err_;
  EXPECT_EQ(report("tables " + (folder_ / "b.json").string()), 4);
  EXPECT_EQ(out_, "");
}

TEST_F(Compare, UnreadableRecordsEndWithCode65AndTheFile) {
  const std::string text = newest_.dump();
  EXPECT_EQ(compare(text.substr(0, text.size() / 2)), 65);
  EXPECT_TRUE(complains("b.json: line 1, column ")) << err_;
  newest_["schema_version"] = "3.0.0";
  EXPECT_EQ(compare(newest_), 65);
  EXPECT_TRUE(complains("b.json: /schema_version: schema version 3.0.0, and only 2.0.0 is read"))
      << err_;
  EXPECT_EQ(report("compare no_such.json no_such.json"), 65);
  EXPECT_TRUE(complains("no_such.json: there is no such file")) << err_;
}

TEST_F(Compare, AFailedCellShowsNoTime) {
  Json& candidate = candidate_of(newest_, "truck_suspension", 114, "global_automatic_klu");
  candidate["time"]["seconds"] = {777.0};
  candidate["verification"]["position"] = 1;  // more than is allowed
  EXPECT_EQ(compare(newest_), 0);
  EXPECT_NE(out_.find("FAILED"), std::string::npos);
  EXPECT_EQ(out_.find("777"), std::string::npos);
}

TEST_F(Compare, UsageErrors) {
  EXPECT_EQ(report("compare"), 64);
  EXPECT_EQ(report("compare only_one.json"), 64);
  EXPECT_EQ(report("compare a.json b.json --format pdf"), 64);
}

}  // namespace
}  // namespace desmo::report::compare_program_test
