// Marks, scales and lines of single figures.
#include "report/figures/figures.h"

#include <set>

#include "tests/report/points_sample.h"
#include "tests/report/size_sample.h"

namespace desmo::report::figures_test {
namespace {

/// The specification of a figure of a record's report.
Json figure_of(const Json& record, const std::string& name) {
  for (const NewFile& file : figures(make_report(record_from(record))))
    if (file.file_name == name + ".vl.json") return Json::parse(file.content);
  ADD_FAILURE() << "no figure " << name;
  return nullptr;
}

Json find(const Json& spec, const Json& wanted) {
  for (const Json& value : spec["data"]["values"]) {
    bool found = true;
    for (const auto& [key, expected] : wanted.items()) found = found && value[key] == expected;
    if (found) return value;
  }
  return nullptr;
}

const std::string klu = "global_automatic_klu", truck_front = "work_precision_truck_suspension";

TEST(FigureFive, ShowsOursAndThePapers) {
  Json record = complete_record();
  set_samples(record, 336, "group_symbolic_klu", {0.3, 0.1, 0.2});
  fail_candidate(record, 336, "group_symbolic_lapack");
  const Json spec = figure_of(record, "figure5");
  EXPECT_EQ(spec["data"]["values"].size(), 4u * 7 * 5);
  const Json place{{"sparse solver", "klu"}, {"analysis", "TS-TPS sparse"}, {"coordinates", "336"}};
  EXPECT_EQ(find(spec, place)["seconds"], 0.2);
  EXPECT_FALSE(find(spec, place).contains("median"));  // it is the time
  const Json disturbed = find(figure_of(with_windows(record), "figure5"), place);
  EXPECT_EQ(disturbed["seconds"], 0.1);
  EXPECT_EQ(disturbed["median"], 0.2);
  const Json failed = find(
      spec, {{"sparse solver", "umfpack"}, {"analysis", "TS-TPS LAPACK"}, {"coordinates", "336"}});
  EXPECT_TRUE(failed["seconds"].is_null());
  EXPECT_EQ(failed["shown"], failed_mark);
  EXPECT_TRUE(find(spec, {{"sparse solver", "MA27 (the paper)"}, {"analysis", "FBL-TP"}})["seconds"]
                  .is_null());  // the paper gives no number
}

TEST(FigureFive, NamesTheMotionsThatDiffer) {
  Json record = complete_record();
  set_motion(record, 2);
  const Json spec = figure_of(record, "figure5");
  EXPECT_FALSE(find(spec, {{"sparse solver", "MA27 (the paper, 30 s)"}}).is_null());
  EXPECT_FALSE(find(spec, {{"sparse solver", "klu (ours, 2 s)"}}).is_null());
  EXPECT_EQ(spec["title"]["subtitle"],
            "Ours is 2 s of motion, the paper's 30 s: these times are not to be compared.");
}

TEST(FigureSix, SkipsFamiliesWithoutACandidateAndKeepsTheColours) {
  Json record = complete_record();
  for (const char* family : {"cholmod", "umfpack"}) erase_family(record, family);
  const Json spec = figure_of(record, "figure6");
  const Json scale = spec["layer"][0]["encoding"]["color"]["scale"];
  EXPECT_EQ(scale["domain"], Json({"MA27 (the paper)", "klu"}));
  EXPECT_EQ(scale["range"], Json({"#7a7a7a", "#d55e00"}));
  EXPECT_EQ(spec["params"][0]["value"], scale["domain"]);
}

TEST(WorkPrecision, FamiliesKeepTheirMarksAndUnknownOnesGetACross) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(solved_point("tearing_symbolic_klu", 10, 1e-9));
  const Json spec = figure_of(json, truck_front);
  const Json& encoding = spec["vconcat"][0]["layer"][0]["encoding"];
  EXPECT_EQ(encoding["color"]["scale"]["domain"],
            Json({"global, sparse", "group, sparse", "group, dense", "tearing, sparse"}));
  EXPECT_EQ(encoding["color"]["scale"]["range"],
            Json({"#7a7a7a", "#0072b2", "#0072b2", "#888888"}));
  EXPECT_EQ(encoding["shape"]["scale"]["range"], Json({"circle", "circle", "square", "cross"}));
}

TEST(WorkPrecision, TheFrontIsWhatNothingElseBeatsInBoth) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(solved_point(klu + "/stride:8", 5, 1e-9));
  const Json spec = figure_of(json, truck_front);
  std::set<std::string> front;
  for (const Json& mark : spec["data"]["values"])
    if (mark["Pareto"] == "front") front.insert(mark["id"]);
  EXPECT_EQ(front, (std::set<std::string>{klu + "/guess:hermite5/jacobian:step/iterations:1",
                                          klu + "/guess:hermite5/tolerance:1e-8",
                                          klu + "/guess:hermite5", klu}));
  EXPECT_EQ(find(spec, {{"id", klu + "/stride:8"}})["family"], "interpolated");
}

// Whatever beats them, a formulation's paper settings are drawn: they are what readers know.
TEST(WorkPrecision, DrawsOfEachFormulationWhatItsOtherSettingsDoNotBeat) {
  Json json = points_record();
  const std::string lapack = "group_symbolic_lapack";
  json["accuracy"]["points"].push_back(solved_point(lapack + "/guess:linear", 95, 5e-6));
  json["accuracy"]["points"].push_back(solved_point(lapack + "/guess:quadratic", 110, 1e-15));
  const Json spec = figure_of(json, truck_front);
  EXPECT_NE(find(spec, {{"id", lapack}}), nullptr);  // "/guess:hermite5" is faster and more exact
  EXPECT_NE(find(spec, {{"id", lapack + "/guess:quadratic"}}), nullptr);
  EXPECT_EQ(find(spec, {{"id", lapack + "/guess:linear"}}), nullptr);
  EXPECT_NE(find(spec, {{"id", lapack + "/scalar:mixed"}}), nullptr);  // of another scalar
}

TEST(WorkPrecision, FailuresHaveAPanelOfTheirOwn) {
  Json json = points_record();
  const Json spec = figure_of(json, truck_front);
  ASSERT_EQ(spec["vconcat"].size(), 2u);
  const Json failed = find(spec, {{"id", "group_symbolic_lapack/scalar:float"}});
  EXPECT_EQ(failed["remark"], "no convergence at t = 0.01 s, residual 1e-06, group 'axle1/i'");
  EXPECT_TRUE(failed["µs/step"].is_null());
  point_of(json, "group_symbolic_lapack/scalar:float")["status"] = "not_applicable";
  EXPECT_EQ(figure_of(json, truck_front)["vconcat"].size(), 1u);
}

TEST(WorkPrecision, DrawsTheFloorAndThePredictedLimits) {
  Json json = points_record();
  const auto lines = [&] { return figure_of(json, truck_front)["datasets"]["lines"]; };
  ASSERT_EQ(lines().size(), 3u);
  EXPECT_EQ(lines()[0]["what"], "floor of the reference 4.0e-33");
  EXPECT_EQ(lines()[1]["what"], "κ u, double 1.1e-13");
  EXPECT_EQ(lines()[2]["at"], 6e-5);
  json["accuracy"]["floors"][0].erase("condition");
  EXPECT_EQ(lines().size(), 1u);
}

TEST(Growth, DrawsTheCachesOfTheMachine) {
  const Json lines = figure_of(sizes_record(), "growth")["datasets"]["lines"];
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0]["what"], "L1 10 KiB");
  EXPECT_EQ(lines[0]["at"], 10);
  EXPECT_EQ(lines[1]["what"], "L2 100 KiB");
}

}  // namespace
}  // namespace desmo::report::figures_test
