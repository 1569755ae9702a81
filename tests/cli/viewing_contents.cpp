// desmo view: what the page tells of a mechanism and its motion, and of where it fails.

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/view.h"
#include "tests/wheel.h"

namespace desmo::viewing_contents_test {
namespace {

TEST_F(View, SaysWhatThereIs) {
  const Json data = viewed("four_bar:2");
  EXPECT_EQ(data["mechanism"]["dimension"], 2);
  EXPECT_EQ(data["shown"], 3001);
  EXPECT_EQ(data["mechanism"]["bodies"].size(), 5u);
  EXPECT_EQ(data["mechanism"]["drivers"], Json{"crank/theta"});
  EXPECT_EQ(data["flags"], Json::array());
  std::vector<std::string> groups;
  for (const Json& group : data["groups"]) groups.push_back(group["name"]);
  EXPECT_EQ(groups, (std::vector<std::string>{"SG-I", "dyad1/SG-I", "dyad2/SG-I"}));
}

TEST_F(View, PlotsMeasuresByTheNamesOfTheirColumns) {
  write("rest.json", R"({"format": "desmo-scene", "version": 2,
    "mechanism": {"library": "slider_crank"}, "time": {"end": 1, "step": 0.1},
    "motion": {"theta": {"type": "trapezoid", "from": 10, "by": 100, "velocity": 200,
                         "acceleration": 1000}},
    "request": [{"rotations": ["rod"], "joints": ["revolute/ground/crank"], "level": "velocity"},
                {"ratios": {"i": ["s", "theta"]}}]})");
  EXPECT_EQ(lines_of("solve rest.json --quiet")[0],
            "t [s],rod.rotation [deg],rod.omega [deg/s],revolute/ground/crank.angle [deg],"
            "d/dt revolute/ground/crank.angle [deg/s],i [mm/deg]");
  EXPECT_FALSE(lines()[1].ends_with(",")) << "a limit, where the motion begins";
  EXPECT_TRUE(lines().back().ends_with(",0,")) << "none, where it rests: " << lines().back();
  ASSERT_EQ(desmo("solve rest.json --format jsonl --strict"), 0) << err_;
  EXPECT_TRUE(lines().back().ends_with(",0,null,null]")) << lines().back();
  ASSERT_EQ(shell("printf '0 10 0 0\n0.1 20 200 0\n' | " DESMO_CLI
                  " solve rest.json --drivers - --units si"),
            0)
      << err_;
  EXPECT_TRUE(prints("i [m/rad],outcome")) << out_;
  const Json data = viewed("rest.json --quiet");
  std::string plotted;
  for (const Json& c : data["plotted"])
    plotted += data["columns"][c.get<std::size_t>()]["name"].get<std::string>() + " " +
               data["columns"][c.get<std::size_t>()]["level"].dump() + ",";
  EXPECT_EQ(plotted,
            "rod.rotation 0,rod.omega 0,revolute/ground/crank.angle 0,"
            "d/dt revolute/ground/crank.angle 1,i 0,");
  EXPECT_EQ(desmo("view rest.json -o out/x.html --units si --quiet"), 0) << err_;
}

TEST_F(View, ShowsHowFarAMechanismGetsThatLocks) {
  write("scene.json", locks);
  expect_said(1, "view scene.json -o out/page.html", "group 'SG-II' (rod, slider)",
              "the page shows the last position");
  const Json data = data_of(text_of(out("page.html")));
  // Rows beyond an interval that cannot be assembled are on an unknown branch.
  std::vector<std::string> kinds;
  for (const Json& f : data["flags"]) kinds.push_back(f["kind"]);
  EXPECT_EQ(kinds, (std::vector<std::string>{"failed", "branch", "failed", "branch"}));
  const Json& flag = data["flags"][0];
  const double reached = std::asin(30. / 50) / (2 * std::numbers::pi);  // where the rod is upright
  EXPECT_NEAR(flag["from"].get<double>(), reached, 2e-9);
  EXPECT_NEAR(flag["to"].get<double>(), 0.5 - reached, 2e-9);
  EXPECT_FALSE(flag["open"].empty());
  EXPECT_LT(data["shown"], 101);
}

TEST_F(View, FlagsWhatIsNotProven) {
  // In one step past where it locks.
  write("scene.json", slider_crank(49, R"(, "time": {"start": 0.19, "end": 0.31, "step": 0.12})"));
  expect_said(0, "view scene.json --quiet", "accuracy: degraded: 1 row of 2");
  const Json flags = data_of(out_)["flags"];
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0]["kind"], "branch");
  EXPECT_EQ(flags[0]["from"], 0.31);
  EXPECT_NE(flags[0]["text"].get<std::string>().find("past a singular position"),
            std::string::npos);
}

TEST_F(View, ShowsTheEstimateWhereNothingCanBeAssembled) {
  const std::vector<double> at{0, 20, 40, 60, 80, 100, 120}, rise{0, 5, 15, 20, 15, 5, 0};
  const Wheel beyond{.couplings = coupling_table("rise", at, rise), .driver = "w", .start = 30};
  const std::pair<std::string, const char*> scenes[] = {
      {slider_crank(30, R"(, "time": {"start": 0.25, "end": 0.3, "step": 0.01})"),
       "t = 0.25 s: no position was found"},
      {beyond.text(), "the motion locks: the table has an extremum at a = 60 deg"},
      {measured_distance("[200, 0]"),
       "constraint 'd: definition', t = 0 s: the drawing is singular"}};
  for (const auto& [scene, why] : scenes) {
    write("scene.json", scene);
    expect_said(1, "view scene.json -o out/page.html", why, "the page shows the initial estimate");
    const Json data = data_of(text_of(out("page.html")));
    EXPECT_EQ(data["time"]["solved"], 0);
    EXPECT_EQ(data["shown"], 1);
    EXPECT_EQ(data["flags"][0]["kind"], "failed");
  }
}

TEST_F(View, LeavesOutPointsThatNoBodyCarries) {
  write("scene.json", replaced(slider_crank(150, R"(, "time": {"end": 1, "step": 0.1})"),
                               R"("points": {)", R"("points": {"Z": [7, 7], )"));
  const Json data = viewed("scene.json");
  EXPECT_EQ(data["points"].size(), 3u);
  for (const Json& point : data["points"]) EXPECT_NE(point["name"], "Z");
}

TEST_F(View, IsInTheUnitsOfTheScene) {
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1})"));
  const auto units = [&](const std::string& options) {
    const Json data = viewed("scene.json" + options);
    std::map<std::string, std::string> result;
    for (const Json& column : data["columns"]) result[column["name"]] = column["unit"];
    result["arrows"] = data["units"].dump();
    return result;
  };
  auto of_file = units(""), si = units(" --units si");
  EXPECT_EQ(of_file["theta"], "deg");
  EXPECT_EQ(of_file["d2/dt2 C.x"], "mm/s^2");
  EXPECT_EQ(of_file["arrows"], R"(["mm","mm/s","mm/s^2"])");
  EXPECT_EQ(si["theta"], "rad");
  EXPECT_EQ(si["d/dt C.x"], "m/s");
}

}  // namespace
}  // namespace desmo::viewing_contents_test
