// desmo solve --drivers: rows of driver values, answered one by one.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "tests/cli/program.h"
#include "tests/parallelogram.h"

namespace desmo::live_test {
namespace {

/// The drivers of a row are exact, those of a motion rounded, and a row of degrees is one of
/// radians but for one rounding: answers may differ in last digits.
TEST_F(Cli, AnswersTheRowsOfAMotionAsItSolvesTheMotion) {
  const std::tuple<std::string, bool, double> ways[] = {
      {"si", false, 1e-14}, {"si", true, 1e-14}, {"file", false, 1e-13}};
  for (const auto& [unit_system, is_json, tolerance] : ways) {
    const std::string solve = "solve slider_crank --units " + unit_system;
    std::vector<std::string> units;  // by column
    for (const std::string& heading : cells(lines_of(solve + " --quiet")[0]))
      units.push_back(heading.substr(heading.rfind('[')));
    write("motion.csv", out_);
    const std::string json = is_json ? " --format jsonl" : "";
    const std::vector<std::string> motion =
        lines_of(solve + " --quiet" + (is_json ? json : " --columns flag"));
    expect_said(0, solve + " --drivers motion.csv" + json, "rows proven; condition");
    const std::vector<std::string> answers = lines();
    ASSERT_EQ(answers.size(), motion.size());
    EXPECT_EQ(answers[0], replaced(motion[0], "flag", "outcome"));
    std::map<std::string, double> sizes;  // largest number in each unit
    for (std::size_t i = 1; i < motion.size(); ++i)
      for (std::size_t k = 0; k < units.size(); ++k)
        sizes[units[k]] = std::max(sizes[units[k]], std::abs(numbers_before_last(motion[i]).at(k)));
    for (std::size_t i = 1; i < motion.size(); ++i) {
      EXPECT_TRUE(answers[i].ends_with(is_json ? ",\"converged\"]" : ",converged")) << answers[i];
      const std::vector<double> wanted = numbers_before_last(motion[i]),
                                got = numbers_before_last(answers[i]);
      ASSERT_EQ(got.size(), wanted.size());
      for (std::size_t k = 0; k < got.size(); ++k)
        EXPECT_NEAR(got[k], wanted[k], tolerance * (1 + sizes[units[k]])) << answers[i];
    }
  }
}

/// A crank of 50 mm, a quarter turn on, at 360 deg/s.
TEST_F(Cli, ReadsAndAnswersRowsInTheUnitsOfTheScene) {
  write("rows", "0 0 360 0\n0.25 90 360 0\n");
  expect_said(0, "solve slider_crank --drivers rows",
              "; relative to 200 mm or 57.3 deg, 314 mm/s or 360 deg/s, ");
  EXPECT_TRUE(lines()[0].starts_with("t [s],B.x [mm],B.y [mm],d/dt B.x [mm/s],")) << lines()[0];
  const std::vector<double> row = numbers_before_last(lines()[2]);
  EXPECT_NEAR(row[2], 50, 1e-9);
  EXPECT_NEAR(row[3], -100 * std::numbers::pi, 1e-9);
}

TEST_F(Cli, AnswersARowBeforeTheNextOneComes) {
  ASSERT_EQ(shell("mkfifo rows && { " DESMO_CLI
                  " solve slider_crank --drivers - --quiet <rows >answers & }"
                  " && exec 3>rows && echo '0 0 1 0' >&3"
                  " && for i in $(seq 200); do"
                  "   [ $(wc -l <answers) -ge 2 ] && break; sleep 0.1; done"
                  " && wc -l <answers && exec 3>&- && wait"),
            0)
      << err_;
  EXPECT_EQ(out_, "2\n");
}

TEST_F(Cli, AnswersRowsOfPositionsAlone) {
  write("scene.json", R"({"format": "desmo-scene", "version": 2,
    "mechanism": {"library": "slider_crank"}, "motion": {"theta": {"type": "constant", "value": 20}},
    "time": {"end": 1, "step": 0.5}, "request": [{"points": ["B"], "level": "position"}]})");
  write("rows", "0 15\n0.1 30\n0.2 120\n");
  expect_said(0, "solve scene.json --drivers rows -o out/motion.csv",
              "; relative to 50 mm or 57.3 deg\n");
  out_ = text_of(out("motion.csv"));
  ASSERT_EQ(lines().size(), 4u);
  for (const auto& [line, angle] :
       std::initializer_list<std::pair<int, double>>{{1, 15}, {2, 30}, {3, 120}}) {
    const std::string row = lines()[line];
    ASSERT_TRUE(row.ends_with(",converged")) << row;
    const std::vector<double> values = numbers_before_last(row);
    ASSERT_EQ(values.size(), 3u);
    EXPECT_NEAR(values[1], 50 * std::cos(angle * std::numbers::pi / 180), 1e-9);
    EXPECT_NEAR(values[2], 50 * std::sin(angle * std::numbers::pi / 180), 1e-9);
  }
}

/// Some programs begin files with a byte order mark.
TEST_F(Cli, ReadsRowsAfterAByteOrderMark) {
  for (const std::string rows : {"t,theta,d/dt theta,d2/dt2 theta\n0,15,1,0\n", "0,15,1,0\n"}) {
    write("rows", "\xEF\xBB\xBF" + rows);
    EXPECT_EQ(lines_of("solve slider_crank --drivers rows").size(), 2u) << out_;
  }
}

/// It locks beyond 36.9 degrees, so no way leads from the drawing to the first row.
TEST_F(Cli, SaysOfARowThatFailsWhatWasDegradedBefore) {
  write("locks.json", locks);
  write("rows", "0 170 1 0\n0.1 171 1 0\n0.2 57 1 0\n");
  expect_said(1, "solve locks.json --drivers rows",
              "accuracy: degraded: 2 rows of 2, the first at ", "rows: line 3: group 'SG-II'");
}

TEST_F(Cli, RefusesARowToWhichNoMotionLeads) {
  write("locks.json", locks);
  write("rows", "0 30 1 0\n1 150 1 0\n");
  expect_said(1, "solve locks.json --drivers rows", "rows: line 2: group 'SG-II'",
              "s to 1 s: the motion cannot be followed past a singular position");
  expect_said(0, "solve locks.json --drivers rows --check none",
              "note: nothing is proven (--check none)");
  EXPECT_EQ(lines().size(), 3u);
  expect_said(64, "solve locks.json --drivers rows --check sample",
              "--check with --drivers: proof or none");
}

/// A parallelogram, drawn upright, is flat at half a turn. Straight lines between rows
/// reach 3.1416, which is so near to it that tests run out.
TEST_F(Cli, NamesSingularPositionsWhereTestsOfARowRunOut) {
  write("scene.json", replaced(parallelogram_scene, R"(, "level": "acceleration")", ""));
  write("rows", "0 1.5707963267948966\n1 2.827433388230814\n2 3.141592653589793\n");
  expect_said(1, "solve scene.json --units si --drivers rows",
              "is not known; take smaller steps, or keep away from singular positions, such as "
              "change points, near which tests run out\n");
}

TEST_F(Cli, GoesOnAfterARowThatFailsWhenItIsTold) {
  write("locks.json", locks);
  // It locks beyond 36.9 degrees.
  write("rows", "# t theta\n");
  EXPECT_EQ(desmo("solve locks.json --drivers rows"), 65);
  write("rows", "0 0 1 0\n0.1 6 1 0\n\n0.2 57 1 0\n0.3 12 1 0\n0.3 17 1 0\n0.4 nan 1 0\n");
  expect_said(1, "solve locks.json --drivers rows", "rows: line 4: group 'SG-II'",
              "no position was found");
  EXPECT_EQ(lines().size(), 3u);
  expect_said(0, "solve locks.json --drivers rows --past-failures",
              "line 6: t = 0.3 s is not after", "line 7: a number is not finite",
              "not solved: 3 rows");
  const std::vector<std::string> answers = lines();
  ASSERT_EQ(answers.size(), 7u);
  for (const auto& [line, outcome] : std::initializer_list<std::pair<int, std::string>>{
           {1, "converged"}, {3, "failed"}, {4, "converged"}, {5, "refused"}, {6, "refused"}})
    EXPECT_TRUE(answers[line].ends_with("," + outcome)) << answers[line];
  EXPECT_TRUE(answers[3].starts_with("0.2,,,")) << answers[3];
  expect_said(0, "solve locks.json --drivers rows --past-failures --check none",
              "not solved: 3 rows");
}

TEST_F(Cli, NamesLineAndColumnOfARowThatCannotBeRead) {
  for (const auto& [rows, message] : std::initializer_list<std::pair<std::string, std::string>>{
           {"0,0,1,0\n1,0,1,0\n2,0,one,0\n", "line 3, column 3: 'one' is not a number; write one"},
           {"0,0,1,0\n1,0,1\n", "line 2, column 4: 3 numbers, where 4 are expected; write as many"},
           {"0,0,1\n",
            "line 1, column 4: 3 numbers, where 4 are needed; write t [s],theta [deg],d/dt theta "
            "[deg/s]"},
           {"t,theta,d/dt theta\n", "line 1, column 1: there is no column 'd2/dt2 theta'"},
           {"theta,d/dt theta,d2/dt2 theta\n", "line 1, column 1: there is no column t"},
           {"0;0;1;0\n", "line 1, column 1: there is no column t"},
           {"0,0,1,0\n1;0,1,0,0\n", "line 2, column 1: '1;0' is not a number"},
           {"t [s],theta [rad]\n",
            "line 1, column 2: 'theta [rad]': the unit is deg (with --units"},
           {"t,theta,theta\n", "line 1, column 3: 'theta' stands there twice"}}) {
    write("rows", rows);
    expect_said(65, "solve slider_crank --drivers rows", "rows: " + message);
  }
  EXPECT_EQ(desmo("solve slider_crank --drivers none"), 66);
  EXPECT_EQ(desmo("solve - --drivers -"), 64);
  expect_said(64,
              "solve slider_crank --drivers rows --formulation "
              "group_symbolic_explicit/threads:2",
              "need a motion known in advance");
}

}  // namespace
}  // namespace desmo::live_test
