// Several records on one page, as a user asks for it.
#include <fstream>

#include "tests/report/points_sample.h"
#include "tests/report/program.h"

namespace desmo::report::joint_page_test {
namespace {

class JointPage : public Program {
 protected:
  // The newest record of candidates and this one of points on one page.
  int joined(const Json& points, const std::string& options = "") {
    std::ofstream(folder_ / "points.json") << points.dump();
    return tables(data_file("origins.json"), (folder_ / "points.json").string() + " " + options);
  }

  // Made-up points of the machine and build that the candidates are of, in a shorter motion.
  Json points() const {
    Json json = points_record();
    const Json settings = json["record"]["settings"];
    json["record"] = Json::parse(read_text(data_file("origins.json")))["record"];
    for (const char* key : {"step_seconds", "duration_seconds", "instants"})
      json["record"]["settings"][key] = settings[key];
    return json;
  }
};

TEST_F(JointPage, HasTheSectionsOfBoth) {
  ASSERT_EQ(joined(points(), "--out " + (folder_ / "out").string()), 0) << err_;
  const auto files = files_in(folder_ / "out");
  for (const char* name :
       {"table1_klu.csv", "figure5.vl.json", "accuracy_costs.csv", "sensitivity.csv",
        "work_precision_truck_suspension.vl.json", "provenance.csv", "provenance_2.csv"})
    EXPECT_EQ(files.count(name), 1u) << name;
  for (const char* name : {"tables.txt", "tables.md", "report.html"})
    for (const char* title : {"Every formulation", "What accuracy costs"})
      EXPECT_NE(files.at(name).find(title), std::string::npos) << name;
  EXPECT_EQ(joined(points(), "--all"), 0);
  const std::string printed = out_;  // the first record is not the foremost
  EXPECT_EQ(tables(folder_ / "points.json", data_file("origins.json").string() + " --all"), 0);
  EXPECT_EQ(out_.substr(0, out_.find("How it was measured")),
            printed.substr(0, printed.find("How it was measured")));
}

TEST_F(JointPage, OfRecordsThatDifferIsRefusedWithTheReason) {
  Json json = points();
  json["record"]["blas"]["core"] = "Abacus";
  EXPECT_EQ(joined(json, "--out " + (folder_ / "out").string()), 4);
  EXPECT_NE(err_.find("points.json cannot be compared:\nBLAS core: "), std::string::npos) << err_;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  json = points();
  json["record"]["settings"]["tolerance"] = 1e-5;
  EXPECT_EQ(joined(json), 4);
  EXPECT_NE(err_.find("tolerance: "), std::string::npos) << err_;
}

TEST_F(JointPage, HasOneRecordOfEachKind) {
  const std::string candidates = data_file("origins.json").string();
  EXPECT_EQ(tables(candidates, candidates), 4);
  EXPECT_NE(err_.find("one record with paper: "), std::string::npos) << err_;
  EXPECT_EQ(joined(points(), (folder_ / "points.json").string()), 4);
  EXPECT_NE(err_.find("one record with accuracy: "), std::string::npos) << err_;
}

TEST_F(JointPage, NamesTheFileThatIsWrong) {
  Json json = points();
  json["accuracy"]["points"][2]["status"] = "fine";
  EXPECT_EQ(joined(json), 65);
  EXPECT_NE(err_.find("points.json: /accuracy/points/2/status: "), std::string::npos) << err_;
}

}  // namespace
}  // namespace desmo::report::joint_page_test
