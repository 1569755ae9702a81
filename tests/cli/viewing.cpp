// desmo view: the page, and what a reader sees of it in Chromium.

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "tests/cli/view.h"

namespace desmo::viewing_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t max_page = 2'000'000;  // bytes

/// A bar that turns about the ground. Its points are given in its own frame.
constexpr const char* framed = R"({"format": "desmo-scene", "version": 2,
  "mechanism": {"format": "desmo-mechanism", "version": 1, "name": "bar", "dimension": 2,
    "points": {"O": [0, 0]}, "ground": {"points": ["O"]},
    "bodies": {"bar": {"at": [0, 0, 0.5], "points": {"O": [0, 0], "T": [1, 0]}}},
    "joints": [{"type": "revolute", "bodies": ["ground", "bar"], "points": ["O"]}],
    "coordinates": {"theta": {"angle": ["O", "T"]}}, "drivers": ["theta"]},
  "motion": {"theta": {"type": "polynomial", "coefficients": [0.5, 1]}},
  "time": {"end": 1, "step": 0.1}})";

TEST_F(View, ReplacesNoSceneThatIsRead) {
  ASSERT_EQ(desmo("show slider_crank --scene >scene.json"), 0);
  EXPECT_EQ(desmo("view scene.json -o scene.json"), 64);
  EXPECT_TRUE(says("this is the scene, which is read; give another file")) << err_;
}

TEST_F(View, IsOnePageThatLoadsNothing) {
  ASSERT_EQ(desmo("view slider_crank --quiet"), 0) << err_;
  EXPECT_EQ(err_, "");
  const std::string page = out_;
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_LE(page.size(), max_page);
  for (const char* loads : {"<link", "<img", "<iframe", "<script src", "@import"})
    EXPECT_EQ(page.find(loads), std::string::npos) << loads;
  EXPECT_GT(page.find("url("), page.find("</style>"));
  EXPECT_EQ(page.find("WebGLRenderer"), std::string::npos) << "a page needs no WebGL";
  ASSERT_EQ(desmo("view slider_crank -o out/page.html"), 0) << err_;
  EXPECT_EQ(out_, "");
  EXPECT_TRUE(says("accuracy: 401 of 401 rows proven")) << err_;
  EXPECT_EQ(text_of(out("page.html")), page) << "the same bytes every time";
}

TEST_F(View, SaysWhatThereIs) {
  ASSERT_EQ(desmo("view four_bar:2"), 0) << err_;
  const Json data = data_of(out_);
  EXPECT_EQ(data["mechanism"]["dimension"], 2);
  EXPECT_EQ(data["shown"], 3001);
  EXPECT_EQ(data["mechanism"]["bodies"].size(), 5u);
  EXPECT_EQ(data["mechanism"]["drivers"], Json{"crank/theta"});
  EXPECT_EQ(data["flags"], Json::array());
  std::vector<std::string> groups;
  for (const Json& group : data["groups"]) groups.push_back(group["name"]);
  EXPECT_EQ(groups, (std::vector<std::string>{"SG-I", "dyad1/SG-I", "dyad2/SG-I"}));
}

TEST_F(View, ReadsBodiesWithFramesOfTheirOwn) {
  write("framed.json", framed);
  const int code =
      run_on_page_of("framed.json",
                     "const names = body => body.points.map(p => data.points[p].name);\n"
                     "console.log(data.bodies.map(b => names(b).join(' ')).join('; '));\n");
  if (code == 127) GTEST_SKIP() << err_;  // there is no node
  EXPECT_EQ(out_, "O; O T\n") << err_;
}

TEST_F(View, PlotsWhatTheSceneRequests) {
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1},
    "request": [{"points": ["C"], "level": "velocity"}])"));
  ASSERT_EQ(desmo("view scene.json"), 0) << err_;
  const Json data = data_of(out_);
  std::vector<std::string> plotted;
  for (const int column : data["plotted"]) plotted.push_back(data["columns"][column]["name"]);
  EXPECT_EQ(plotted, (std::vector<std::string>{"C.x", "C.y", "d/dt C.x", "d/dt C.y"}));
}

TEST_F(View, PlotsMeasuresByTheNamesOfTheirColumns) {
  write("rest.json", R"({"format": "desmo-scene", "version": 2,
    "mechanism": {"library": "slider_crank"}, "time": {"end": 1, "step": 0.1},
    "motion": {"theta": {"type": "trapezoid", "from": 10, "by": 100, "velocity": 200,
                         "acceleration": 1000}},
    "request": [{"rotations": ["rod"], "joints": ["revolute/ground/crank"], "level": "velocity"},
                {"ratios": {"i": ["s", "theta"]}}]})");
  ASSERT_EQ(desmo("solve rest.json --quiet"), 0) << err_;
  EXPECT_EQ(lines()[0],
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
  ASSERT_EQ(desmo("view rest.json --quiet"), 0) << err_;
  const Json data = data_of(out_);
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
  ASSERT_EQ(desmo("view scene.json -o out/page.html"), 1);
  EXPECT_TRUE(says("group 'SG-II' (rod, slider)")) << err_;
  EXPECT_TRUE(says("the page shows the last position")) << err_;
  const Json data = data_of(text_of(out("page.html")));
  // What is beyond an interval that cannot be assembled is on an unknown branch.
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
  ASSERT_EQ(desmo("view scene.json --quiet"), 0) << err_;
  EXPECT_TRUE(says("accuracy: degraded: 1 row of 2")) << err_;
  const Json flags = data_of(out_)["flags"];
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0]["kind"], "branch");
  EXPECT_EQ(flags[0]["from"], 0.31);
  EXPECT_NE(flags[0]["text"].get<std::string>().find("past a singular position"),
            std::string::npos);
}

TEST_F(View, ShowsTheEstimateWhereNothingCanBeAssembled) {
  write("scene.json", slider_crank(30, R"(, "time": {"start": 0.25, "end": 0.3, "step": 0.01})"));
  ASSERT_EQ(desmo("view scene.json -o out/page.html"), 1);
  EXPECT_TRUE(says("the page shows the initial estimate")) << err_;
  const Json data = data_of(text_of(out("page.html")));
  EXPECT_EQ(data["time"]["solved"], 0);
  EXPECT_EQ(data["shown"], 1);
  EXPECT_EQ(data["flags"][0]["kind"], "failed");
}

TEST_F(View, LeavesOutPointsThatNoBodyCarries) {
  std::string scene = slider_crank(150, R"(, "time": {"end": 1, "step": 0.1})");
  scene.replace(scene.find("\"points\": {") + 11, 0, "\"Z\": [7, 7], ");
  write("scene.json", scene);
  ASSERT_EQ(desmo("view scene.json"), 0) << err_;
  const Json data = data_of(out_);
  EXPECT_EQ(data["points"].size(), 3u);
  for (const Json& point : data["points"]) EXPECT_NE(point["name"], "Z");
}

TEST_F(View, IsInTheUnitsOfTheScene) {
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1})"));
  const auto units = [&](const std::string& options) {
    EXPECT_EQ(desmo("view scene.json" + options), 0) << err_;
    const Json data = data_of(out_);
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

TEST_F(View, ThinsOutWhatIsTooLongAndSaysSo) {
  write("scene.json", slider_crank(150, R"(, "time": {"end": 100, "step": 0.005})"));
  ASSERT_EQ(desmo("view scene.json"), 0) << err_;
  EXPECT_LE(out_.size(), max_page);
  const Json data = data_of(out_);
  EXPECT_EQ(data["time"]["solved"], 20001);
  EXPECT_EQ(data["time"]["stride"], 4);
  EXPECT_EQ(data["shown"], 5001);
}

TEST_F(View, LeavesNothingHalfWritten) {
  write("mechanism.json", "{\"format\": \"desmo-mechanism\", \"version\": 1}");
  EXPECT_EQ(desmo("view mechanism.json -o out/page.html"), 65);
  EXPECT_TRUE(says("mechanism.json: /format")) << err_;
  EXPECT_EQ(desmo("view nothing -o out/page.html"), 66);
  EXPECT_EQ(desmo("view slider_crank -o nowhere/page.html"), 74);
  EXPECT_EQ(desmo("view four_bar:1000 -o out/page.html"), 65);
  EXPECT_TRUE(says("a page cannot show a mechanism of 3003 coordinates")) << err_;
  EXPECT_TRUE(fs::is_empty(out("")));
}

/// Returns the scene of a chain of four-bars that turns.
std::string chain(int four_bars, const std::string& time) {
  return R"({"format": "desmo-scene", "version": 2, "motion": {"crank/theta":
    {"type": "polynomial", "coefficients": [1, 1]}}, "time": )" +
         time + R"(, "mechanism": )" + write_mechanism(desmo::four_bar(four_bars).mechanism) + "}";
}

/// A page has room for some 20 instants of the short chain, and for 8 of the long one, which would
/// be solved for days.
TEST_F(View, RefusesWhatIsTooLargeBeforeItIsSolved) {
  write("long.json", chain(560, R"({"end": 1, "step": 1e-8})"));
  EXPECT_EQ(desmo("view long.json -o out/page.html"), 65);
  EXPECT_TRUE(says("a page cannot show a mechanism of 1683 coordinates")) << err_;
  EXPECT_TRUE(fs::is_empty(out("")));
  write("short.json", chain(400, R"({"end": 0.1, "step": 0.001})"));
  ASSERT_EQ(desmo("view short.json -o out/page.html"), 0) << err_;
  const std::string page = text_of(out("page.html"));
  EXPECT_LE(page.size(), max_page);
  EXPECT_GE(data_of(page)["shown"], 16);
}

// ---- in a browser ----

class ViewInBrowser : public View {
 protected:
  /// Opens pages in Chromium. Returns what watch.mjs tells of each.
  Json opened(const std::vector<std::string>& scenes) {
    const fs::path source = DESMO_SOURCE_DIR, work = source / "build/browser";
    std::string pages;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const std::string page = out("page" + std::to_string(i) + ".html").string();
      const int expected = scenes[i] == "locks.json" ? 1 : 0;
      EXPECT_EQ(desmo("view " + scenes[i] + " -o " + page), expected) << scenes[i] << err_;
      EXPECT_LE(fs::file_size(page), max_page) << scenes[i];
      pages += " " + page;
    }
    fs::copy_file(source / "tests/cli/browser/watch.mjs", work / "watch.mjs",
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(
        shell("node " + (work / "watch.mjs").string() + " \"$(command -v chromium)\"" + pages), 0)
        << err_;
    return Json::parse(out_);
  }

  /// Whether Chromium and what steers it are there; the reason in out_ when not.
  bool has_browser() {
    if (shell("command -v chromium || { echo Chromium is not installed; false; }") != 0)
      return false;
    const std::string source = DESMO_SOURCE_DIR;
    return shell(source + "/report/figures/render --packages " + source + "/tests/report/browser " +
                 source + "/build/browser") == 0;
  }

  /// The numbers of some instants as `desmo solve` writes them, by names of columns.
  std::map<int, std::map<std::string, double>> solved(const std::string& scene,
                                                      const Json& instants, const Json& time) {
    EXPECT_EQ(desmo("solve " + scene + " --past-failures --quiet -o out/motion.csv"), 0) << err_;
    std::ifstream in(out("motion.csv"));
    std::string line, name;
    std::getline(in, line);
    std::vector<std::string> names;
    for (std::istringstream heading(line); std::getline(heading, name, ',');)
      names.push_back(name.substr(0, name.find(" [")));
    std::map<long, std::string> rows;  // by index: rows leave out instants that were not solved
    while (std::getline(in, line))
      rows[std::lround((std::stod(line) - time["start"].get<double>()) /
                       time["interval"].get<double>())] = line;
    std::map<int, std::map<std::string, double>> result;
    for (const Json& instant : instants) {
      const int k = static_cast<int>(&instant - &instants[0]);
      const std::vector<double> numbers = Cli::numbers(rows.at(instant["index"].get<long>()));
      for (std::size_t i = 0; i < numbers.size(); ++i) result[k][names[i]] = numbers[i];
    }
    return result;
  }

  void expect_positions(const Json& instant, const std::map<std::string, double>& solved,
                        double size) {
    int compared = 0;
    for (const auto& [point, position] : instant["positions"].items())
      for (std::size_t axis = 0; axis < position.size(); ++axis) {
        const auto found = solved.find(point + "." + "xyz"[axis]);
        if (found == solved.end()) continue;  // at rest
        EXPECT_NEAR(position[axis].get<double>(), found->second, 1e-4 * size) << found->first;
        ++compared;
      }
    EXPECT_GT(compared, 0);
  }

  void expect_values(const Json& instant, const std::map<std::string, double>& solved) {
    int compared = 0;
    for (const auto& [name, value] : instant["values"].items()) {
      const auto found = solved.find(name);
      if (found == solved.end()) continue;  // condition, bounds, transmission angles
      EXPECT_NEAR(value.get<double>(), found->second, 1e-6 * std::abs(found->second) + 1e-12)
          << name;
      ++compared;
    }
    EXPECT_GT(compared, 0);
  }

  void expect_word(const Json& seen, const std::string& word) {
    EXPECT_EQ(std::ranges::count(seen["words"], Json(word)), 1) << word << seen["words"];
  }

  /// A picture that needs nothing else, and every instant of the page.
  void expect_saved(const Json& saved, const Json& data) {
    const std::string name = data["mechanism"]["name"], svg = saved["picture"]["text"],
                      csv = saved["data"]["text"];
    EXPECT_EQ(saved["picture"]["name"], name + ".svg");
    EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(svg.find("var("), std::string::npos);
    EXPECT_NE(svg.find(">" + data["points"][0]["name"].get<std::string>() + "</text>"),
              std::string::npos);
    EXPECT_EQ(saved["data"]["name"], name + ".csv");
    EXPECT_TRUE(csv.starts_with("t [s],")) << csv.substr(0, 100);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + data["shown"].get<int>());
  }

  void expect_well(const std::string& scene, const Json& seen, const Json& data) {
    SCOPED_TRACE(scene);
    EXPECT_EQ(seen["requests"], Json::array());
    EXPECT_EQ(seen["errors"], Json::array());
    EXPECT_GE(seen["variety"], 10);
    EXPECT_EQ(seen["folded"], 2) << "condition and bounds";
    EXPECT_EQ(seen["legend"], std::ranges::count(data["groups"], Json(false),
                                                 [](const Json& g) { return g["constant"]; }));
    EXPECT_EQ(seen["bodies"].size(), data["mechanism"]["bodies"].size());
    EXPECT_GT(seen["arrows"], 0);
    for (const Json& point : data["points"]) expect_word(seen, point["name"]);
    expect_word(seen, "x");
    expect_saved(seen["saved"], data);
    EXPECT_EQ(seen["label_when_playing"], "Pause");
    EXPECT_EQ(seen["time_after_one"], 0);
    EXPECT_EQ(seen["inside"], 1);
    EXPECT_TRUE(seen["hint"].get<std::string>().starts_with("point ")) << seen["hint"];
    for (const auto& [width, overflow] : seen["overflow"].items()) EXPECT_EQ(overflow, 0) << width;
    EXPECT_EQ(seen["sheets"], 1);
    EXPECT_EQ(seen["flags"]["listed"].size(), data["flags"].size());
    const Json& numbers = seen["numbers"];
    ASSERT_EQ(numbers.size(), 10u);
    const auto right = solved(scene, numbers, data["time"]);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      expect_positions(numbers[k], right.at(static_cast<int>(k)), seen["size"]);
      expect_values(numbers[k], right.at(static_cast<int>(k)));
    }
    std::printf("%s: %s ms of script a frame in the median of %s, at most %s\n", scene.c_str(),
                seen["script"]["median"].dump().c_str(), seen["script"]["frames"].dump().c_str(),
                seen["script"]["longest"].dump().c_str());
  }

  void expect_all_well(const std::vector<std::string>& scenes) {
    if (!has_browser()) GTEST_SKIP() << out_;
    write("locks.json", locks);
    write("framed.json", framed);
    const Json seen = opened(scenes);
    ASSERT_EQ(seen.size(), scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const std::string page = text_of(out("page" + std::to_string(i) + ".html"));
      expect_well(scenes[i], seen[i], data_of(page));
      const Json& flags = seen[i]["flags"];
      if (scenes[i] != "locks.json") continue;
      const std::string notice = flags["notice"];
      EXPECT_NE(notice.find("group 'SG-II' (rod, slider)"), std::string::npos) << notice;
      EXPECT_NE(notice.find("is off by"), std::string::npos) << notice;
      EXPECT_EQ(flags["hovered"], "failed") << "the cause is told once";
      for (const Json& flag : flags["listed"])
        EXPECT_EQ(flag.get<std::string>().find("SG-II"), std::string::npos) << flag;
    }
  }
};

/// A four-bar with a crank of 2, a coupler of 4, a rocker of 3.5 and a ground of 5, that turns
/// once. side: 1 open, −1 crossed.
std::string four_bar(int side) {
  const double theta = 1, bx = 2 * std::cos(theta), by = 2 * std::sin(theta),
               across = std::hypot(5 - bx, by), ux = (5 - bx) / across, uy = -by / across,
               along = (16 + across * across - 3.5 * 3.5) / (2 * across),
               off = side * std::sqrt(16 - along * along);
  Json scene = Json::parse(R"({"format": "desmo-scene", "version": 2,
    "mechanism": {"format": "desmo-mechanism", "version": 1, "name": "four_bar", "dimension": 2,
      "points": {"A": [0, 0], "D": [5, 0]}, "ground": {"points": ["A", "D"]},
      "bodies": {"crank": {"points": ["A", "B"]}, "coupler": {"points": ["B", "C"]},
                 "rocker": {"points": ["C", "D"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
                 {"type": "revolute", "bodies": ["crank", "coupler"], "points": ["B"]},
                 {"type": "revolute", "bodies": ["coupler", "rocker"], "points": ["C"]},
                 {"type": "revolute", "bodies": ["rocker", "ground"], "points": ["D"]}],
      "coordinates": {"theta": {"angle": ["A", "B"]}}, "drivers": ["theta"]},
    "motion": {"theta": {"type": "polynomial"}}, "time": {"end": 1, "step": 0.01}})");
  Json& points = scene["mechanism"]["points"];
  points["B"] = {bx, by};
  points["C"] = {bx + along * ux - off * uy, by + along * uy + off * ux};
  scene["motion"]["theta"]["coefficients"] = {theta, 2 * std::numbers::pi};
  return scene.dump();
}

/// By the law of cosines: the diagonal from the crank's pin to the rocker's pivot is in both
/// triangles. The angle passes a quarter turn without a kink.
TEST_F(ViewInBrowser, TransmissionAnglesAreThoseOfTheLawOfCosines) {
  if (!has_browser()) GTEST_SKIP() << out_;
  write("open.json", four_bar(1));
  write("crossed.json", four_bar(-1));
  const Json seen = opened({"open.json", "crossed.json"});
  for (const Json& page : seen) {
    ASSERT_EQ(page["numbers"].size(), 10u);
    bool acute = false, obtuse = false;
    for (const Json& instant : page["numbers"]) {
      const double theta = 1 + 2 * std::numbers::pi * 0.01 * instant["index"].get<double>(),
                   diagonal_squared = 29 - 20 * std::cos(theta),
                   right = std::acos((16 + 3.5 * 3.5 - diagonal_squared) / (2 * 4 * 3.5));
      EXPECT_NEAR(instant["values"].at("crank → coupler → rocker").get<double>(), right, 2e-7)
          << theta;
      (right < std::numbers::pi / 2 ? acute : obtuse) = true;
    }
    EXPECT_TRUE(acute && obtuse);
  }
  // The same angles on both branches, but not the same positions.
  EXPECT_NE(seen[0]["numbers"][3]["positions"]["C"], seen[1]["numbers"][3]["positions"]["C"]);
}

TEST_F(ViewInBrowser, ShowsWhatIsSolved) {
  expect_all_well({"slider_crank", "locks.json", "framed.json", "truck_suspension:1"});
}

/// Every mechanism, in minutes: program_test --gtest_also_run_disabled_tests
/// --gtest_filter='ViewInBrowser.*'
TEST_F(ViewInBrowser, DISABLED_ShowsWhatIsSolvedOfEveryMechanism) {
  std::vector<std::string> scenes{"locks.json", "four_bar:1", "four_bar:40", "truck_suspension:1",
                                  "truck_suspension:5"};
  for (const LibraryMechanism& m : library()) scenes.emplace_back(m.name);
  expect_all_well(scenes);
}

}  // namespace
}  // namespace desmo::viewing_test
