// desmo view: what a reader sees of the page in Chromium.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "cases/generators/dyad_chain.h"
#include "cases/library/library.h"
#include "tests/cli/view.h"
#include "tests/parallelogram.h"

namespace desmo::viewing_browser_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A bar that turns about the ground. Its points are given in its own frame.
constexpr const char* framed = R"({"format": "desmo-scene", "version": 2,
  "mechanism": {"format": "desmo-mechanism", "version": 1, "name": "bar", "dimension": 2,
    "points": {"O": [0, 0]}, "ground": {"points": ["O"]},
    "bodies": {"bar": {"at": [0, 0, 0.5], "points": {"O": [0, 0], "T": [1, 0]}}},
    "joints": [{"type": "revolute", "bodies": ["ground", "bar"], "points": ["O"]}],
    "coordinates": {"theta": {"angle": ["O", "T"]}}, "drivers": ["theta"]},
  "motion": {"theta": {"type": "polynomial", "coefficients": [0.5, 1]}},
  "time": {"end": 1, "step": 0.1}})";

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

  /// Returns whether Chromium and what steers it are there. If not, out_ has the reason.
  bool has_browser() {
    if (shell("command -v chromium || { echo Chromium is not installed; false; }") != 0)
      return false;
    const std::string source = DESMO_SOURCE_DIR;
    return shell(source + "/report/figures/render --packages " + source + "/tests/report/browser " +
                 source + "/build/browser") == 0;
  }

  /// The numbers of some instants as `desmo solve` writes them, by names of columns.
  std::vector<std::map<std::string, double>> solved(const std::string& scene, const Json& instants,
                                                    const Json& time) {
    EXPECT_EQ(desmo("solve " + scene + " --past-failures --quiet -o out/motion.csv"), 0) << err_;
    std::ifstream in(out("motion.csv"));
    std::string line;
    std::getline(in, line);
    std::vector<std::string> names;
    for (const std::string& heading : cells(line))
      names.push_back(heading.substr(0, heading.find(" [")));
    std::map<long, std::string> rows;  // by index: rows leave out instants that were not solved
    while (std::getline(in, line))
      rows[std::lround((std::stod(line) - time["start"].get<double>()) /
                       time["interval"].get<double>())] = line;
    std::vector<std::map<std::string, double>> result;
    for (const Json& instant : instants) {
      const std::vector<double> numbers = Cli::numbers(rows.at(instant["index"].get<long>()));
      std::map<std::string, double>& by_name = result.emplace_back();
      for (std::size_t i = 0; i < numbers.size(); ++i) by_name[names[i]] = numbers[i];
    }
    return result;
  }

  /// Expects numbers of a page, by their names, to be those that are solved.
  void expect_numbers(const Json& shown, const std::map<std::string, double>& solved,
                      double absolute, double relative) {
    int compared = 0;
    for (const auto& [name, value] : shown.items()) {
      const auto found = solved.find(name);
      if (found == solved.end()) continue;  // at rest; condition, bounds, transmission angles
      EXPECT_NEAR(value.get<double>(), found->second, relative * std::abs(found->second) + absolute)
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
      Json positions;
      for (const auto& [point, position] : numbers[k]["positions"].items())
        for (std::size_t axis = 0; axis < position.size(); ++axis)
          positions[point + "." + "xyz"[axis]] = position[axis];
      expect_numbers(positions, right[k], 1e-4 * seen["size"].get<double>(), 0);
      expect_numbers(numbers[k]["values"], right[k], 1e-12, 1e-6);
    }
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
  const double theta = 1;
  const Mechanism::Vec b{2 * std::cos(theta), 2 * std::sin(theta), 0},
      c = closed_dyad(b, {5, 0, 0}, 4, 3.5, side).joint;
  Json scene = Json::parse(parallelogram_scene);
  scene.erase("request");
  scene["mechanism"].erase("units");
  scene["mechanism"]["points"] = {
      {"A", {0, 0}}, {"B", {b[0], b[1]}}, {"C", {c[0], c[1]}}, {"D", {5, 0}}};
  scene["motion"]["theta"]["coefficients"] = {theta, 2 * std::numbers::pi};
  scene["time"]["step"] = 0.01;
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
      EXPECT_NEAR(instant["values"].at("crank → rod → rocker").get<double>(), right, 2e-7) << theta;
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
}  // namespace desmo::viewing_browser_test
