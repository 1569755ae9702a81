// desmo solve: the formats, headings and times of its rows.

#include <algorithm>
#include <cmath>

#include "tests/cli/program.h"

namespace desmo::solve_output_test {
namespace {

TEST_F(Cli, SolvesToTheSameNumbersInEitherFormat) {
  ASSERT_EQ(desmo("solve slider_crank --quiet -o -"), 0) << err_;
  EXPECT_EQ(err_, "");
  const std::vector<std::string> csv = lines();
  ASSERT_EQ(csv.size(), 402u);
  EXPECT_TRUE(csv[0].starts_with("t [s],")) << csv[0];
  for (const char* name : {"C.x [mm]", "d/dt C.x [mm/s]", "d2/dt2 C.x [mm/s^2]", "theta [deg]",
                           "d/dt theta [deg/s]", "d2/dt2 phi [deg/s^2]", "s [mm]"})
    EXPECT_NE((csv[0] + ",").find("," + std::string(name) + ","), std::string::npos) << name;

  ASSERT_EQ(desmo("solve slider_crank --quiet -o out/motion.jsonl"), 0) << err_;
  out_ = text_of(out("motion.jsonl"));
  const std::vector<std::string> jsonl = lines();
  ASSERT_EQ(jsonl.size(), csv.size());
  Json heading = Json::parse(jsonl[0]);
  EXPECT_EQ(heading["columns"].back()["name"], "flag");
  heading["columns"].erase(heading["columns"].size() - 1);
  EXPECT_EQ(heading["mechanism"], "slider_crank");
  std::string names;
  for (const Json& column : heading["columns"])
    names += (names.empty() ? "" : ",") + column["name"].get<std::string>() + " [" +
             column["unit"].get<std::string>() + "]";
  EXPECT_EQ(names, csv[0]);
  for (std::size_t i = 1; i < csv.size(); ++i) {
    Json row = Json::parse(jsonl[i]);
    EXPECT_TRUE(row.back().is_null()) << row;
    row.erase(row.size() - 1);
    EXPECT_EQ(row.get<std::vector<double>>(), numbers(csv[i]));
  }

  // After a quarter turn the crank, 50 mm, stands upright; the rod has 150 mm.
  const std::vector<double> quarter = numbers(csv[1 + 100]);
  const std::vector<std::string> headings = cells(csv[0]);
  const auto value = [&](const std::string& name) {
    return quarter[std::ranges::find(headings, name) - headings.begin()];
  };
  EXPECT_NEAR(value("t [s]"), 0.25, 1e-15);
  EXPECT_NEAR(value("B.y [mm]"), 50, 1e-9);
  EXPECT_NEAR(value("s [mm]"), std::sqrt(150. * 150 - 50 * 50), 1e-9);
}

TEST_F(Cli, RefusesEndingsThatItDoesNotKnowBeforeItSolves) {
  for (const char* name : {"motion.tsv", "motion.xlsx", "motion.csv.gz", "motion."}) {
    expect_said(64, "solve slider_crank -o out/" + std::string(name),
                "is not known; known are .csv and .jsonl");
    EXPECT_FALSE(std::filesystem::exists(out(name))) << name;
    EXPECT_EQ(desmo("solve no_such_file.json -o out/" + std::string(name)), 64)
        << "nothing is read";
  }
  EXPECT_EQ(desmo("solve slider_crank --quiet --format csv -o out/motion.tsv"), 0) << err_;
  EXPECT_TRUE(text_of(out("motion.tsv")).starts_with("t [s],"));
  EXPECT_EQ(desmo("solve slider_crank --quiet -o out/motion"), 0) << err_;
  EXPECT_TRUE(text_of(out("motion")).starts_with("t [s],")) << "without an ending it is csv";
}

/// The unfinished file, which has a name of its own, must fit wherever the target does.
TEST_F(Cli, WritesToNamesAsLongAsTheFileSystemHasThem) {
  std::string umlauts;
  for (int i = 0; i < 124; ++i) umlauts += "\xC3\xA4";
  for (const std::string& name : {std::string(240, 'a') + ".csv", umlauts + ".csv"}) {
    EXPECT_EQ(desmo("solve slider_crank --quiet -o out/" + name), 0) << err_;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 1);
    EXPECT_TRUE(std::filesystem::remove(out(name))) << name;
  }
  expect_said(74, "solve slider_crank --quiet -o out/" + std::string(300, 'a') + ".csv",
              "File name too long");
}

TEST_F(Cli, DeliversOnlyWhatIsAskedFor) {
  const auto solve = [&](const std::string& request) {
    write("scene.json",
          slider_crank(150, R"(, "time": {"end": 1, "step": 0.1}, "request": [)" + request + "]"));
    EXPECT_EQ(lines_of("solve scene.json --quiet").size(), 12u);
    EXPECT_EQ(numbers(lines().back()).size(),
              static_cast<std::size_t>(std::ranges::count(lines().front(), ',') + 1));
    return lines().front();
  };
  EXPECT_EQ(solve(R"({"points": ["C"]})"), "t [s],C.x [mm],C.y [mm]");
  EXPECT_EQ(solve(R"({"points": ["B"], "level": "velocity"}, {"angles": ["theta"]})"),
            "t [s],B.x [mm],B.y [mm],d/dt B.x [mm/s],d/dt B.y [mm/s],theta [deg]");
  EXPECT_EQ(solve(R"({"angles": ["theta"], "level": "acceleration"})"),
            "t [s],theta [deg],d/dt theta [deg/s],d2/dt2 theta [deg/s^2]");
  // What never moves is delivered when it is asked for by name.
  EXPECT_EQ(
      solve(R"({"points": ["A"], "vectors": ["x"], "level": "velocity"})"),
      "t [s],A.x [mm],A.y [mm],d/dt A.x [mm/s],d/dt A.y [mm/s],x.x [-],x.y [-],d/dt x.x [1/s],"
      "d/dt x.y [1/s]");
  EXPECT_EQ(numbers(lines().back()), (std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0}));
  expect_printed("solve jansen_leg --quiet", "F.x [1],F.y [1],d/dt F.x [1/s]");
}

TEST_F(Cli, RefusesTwoColumnsOfOneHeading) {
  const auto scene = [&](const std::string& more, const std::string& request) {
    const std::string theta = R"("theta": {"angle": ["A", "B"]})";
    write("scene.json",
          replaced(slider_crank(150, R"(, "time": {"end": 1, "step": 0.5})" + request), theta,
                   theta + more));
  };
  const std::string height = R"(, "C.x": {"component": "B", "axis": "y"})";
  scene(height, "");
  expect_said(65, "solve scene.json",
              "desmo: scene.json: two columns are headed 'C.x [mm]', those of coordinate 'C.x' and "
              "point 'C'; rename one of them, or leave it out of the request");
  scene(height, R"(, "request": [{"points": ["B", "C"], "angles": ["theta"]}])");
  EXPECT_EQ(desmo("solve scene.json"), 0) << err_;
  scene(R"(, "t": {"component": "B", "axis": "y"})", "");  // a length is not the time
  ASSERT_EQ(desmo("solve scene.json --columns flag"), 0) << err_;
  EXPECT_TRUE(prints("t [s],") && prints(",t [mm],")) << out_;
}

/// Solved times are doubles next to what is written.
TEST_F(Cli, WritesTimesAsTheyWereAskedFor) {
  const std::pair<const char*, std::vector<std::string>> grids[] = {
      {R"({"end": 0.7, "step": 0.1})", {"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7"}},
      {R"({"start": -0.1, "end": 0.2, "step": 0.1})", {"-0.1", "0", "0.1", "0.2"}},
      {R"({"start": 1.1, "end": 1.4, "step": 0.1})", {"1.1", "1.2", "1.3", "1.4"}},
      {R"({"start": 1e-5, "end": 3e-5, "step": 1e-5})", {"1e-05", "2e-05", "3e-05"}},
      {R"({"end": 1, "step": 0.333333333333333})",
       {"0", "0.333333333333333", "0.666666666666666", "0.999999999999999"}},
      {R"({"at": 0.30000000000000004})", {"0.30000000000000004"}},
  };
  for (const auto& [grid, expected] : grids) {
    write("scene.json", slider_crank(150, std::string(R"(, "time": )") + grid));
    for (const char* format : {"csv", "jsonl"}) {
      std::vector<std::string> times =
          lines_of("solve scene.json --quiet --format " + std::string(format));
      times.erase(times.begin());
      for (std::string& line : times)
        line = line.substr(line.front() == '[', line.find(',') - (line.front() == '['));
      EXPECT_EQ(times, expected) << format;
    }
  }
}

TEST_F(Cli, TakesNamesWithBlanksAndUmlauts) {
  std::string scene = slider_crank(150, R"(, "time": {"end": 0.2, "step": 0.1},
    "request": [{"points": ["Groß*"], "angles": ["*ä rad"], "level": "velocity"}])");
  const std::pair<std::string, std::string> names[] = {{"\"C\"", "\"Großer Kopf\""},
                                                       {"\"theta\"", "\"Zahn ä rad\""},
                                                       {"\"rod\"", "\"Pleuel 1\""},
                                                       {"\"short\"", "\"Kurbel ü 1\""}};
  for (const auto& [old, by] : names) scene = replaced_everywhere(scene, old, by);
  write("scene.json", scene);
  const std::string heading =
      "t [s],Großer Kopf.x [mm],Großer Kopf.y [mm],d/dt Großer Kopf.x [mm/s],"
      "d/dt Großer Kopf.y [mm/s],Zahn ä rad [deg],d/dt Zahn ä rad [deg/s]";
  ASSERT_EQ(desmo("solve scene.json --quiet -o out/rows.csv"), 0) << err_;
  out_ = text_of(out("rows.csv"));
  EXPECT_EQ(lines().front(), heading);
  const std::string last = lines().back().substr(0, 20);
  EXPECT_EQ(lines_of("solve scene.json --quiet --drivers out/rows.csv").front(),
            heading + ",outcome");
  EXPECT_EQ(lines().back().substr(0, 20), last);
  EXPECT_EQ(lines_of("solve scene.json --quiet --formulation group_symbolic_explicit")
                .back()
                .substr(0, 12),
            last.substr(0, 12));
  expect_printed("range scene.json", "Zahn ä rad, from 0 deg");
  expect_printed("inspect scene.json", "Pleuel 1");
  if (desmo("view scene.json -o out/page.html") == 69) return;  // built without the page
  EXPECT_NE(text_of(out("page.html")).find("Großer Kopf.x"), std::string::npos);
}

}  // namespace
}  // namespace desmo::solve_output_test
