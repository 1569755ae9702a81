// desmo solve --drivers: rows of driver values, answered one by one.

#include <cmath>

#include "tests/cli/program.h"

namespace desmo::live_test {
namespace {

TEST_F(Cli, AnswersTheRowsOfAMotionAsItSolvesTheMotion) {
  for (const char* format : {"csv", "jsonl"}) {
    ASSERT_EQ(desmo("solve slider_crank -o motion.csv --quiet"), 0) << err_;
    ASSERT_EQ(desmo("solve slider_crank --format " + std::string(format) + " --quiet"), 0) << err_;
    const std::vector<std::string> motion = lines();
    ASSERT_EQ(desmo("solve slider_crank --drivers motion.csv --format " + std::string(format)), 0)
        << err_;
    EXPECT_TRUE(says("accuracy: condition")) << err_;
    const std::vector<std::string> answers = lines();
    ASSERT_EQ(answers.size(), motion.size());
    for (std::size_t i = 1; i < motion.size(); ++i)
      EXPECT_EQ(answers[i], format == std::string("csv")
                                ? motion[i] + ",converged"
                                : motion[i].substr(0, motion[i].size() - 1) + ",\"converged\"]");
  }
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
  write("rows", "0 0.3\n0.1 0.4\n0.2 2\n");
  ASSERT_EQ(desmo("solve scene.json --drivers rows -o out/motion.csv"), 0) << err_;
  EXPECT_TRUE(says("; relative to 0.05 m or 1 rad\n")) << err_;
  out_ = text_of(out("motion.csv"));
  ASSERT_EQ(lines().size(), 4u);
  for (const auto& [line, angle] :
       std::initializer_list<std::pair<int, double>>{{1, 0.3}, {2, 0.4}, {3, 2}}) {
    const std::string row = lines()[line];
    ASSERT_TRUE(row.ends_with(",converged")) << row;
    const std::vector<double> values = numbers(row.substr(0, row.rfind(',')));
    ASSERT_EQ(values.size(), 3u);
    EXPECT_NEAR(values[1], 0.05 * std::cos(angle), 1e-12);
    EXPECT_NEAR(values[2], 0.05 * std::sin(angle), 1e-12);
  }
}

TEST_F(Cli, SaysWhatBoundsOfRowsAreRelativeTo) {
  write("rows", "0 0 2 0\n0.5 1 2 0\n");
  ASSERT_EQ(desmo("solve slider_crank --drivers rows"), 0) << err_;
  EXPECT_TRUE(says("; relative to 0.2 m or 1 rad, 0.1")) << err_;
  EXPECT_TRUE(says(" m/s or 2 rad/s, ")) << err_;
}

TEST_F(Cli, SaysOfARowThatFailsWhatWasDegradedBefore) {
  write("locks.json", locks);
  write("rows", "0 0 1 0\n0.1 0.643501108793 1 0\n0.2 1 1 0\n");
  EXPECT_EQ(desmo("solve locks.json --drivers rows"), 1);
  EXPECT_TRUE(says("accuracy: degraded: 1 instant of 2, the first at ")) << err_;
  EXPECT_TRUE(says("rows: line 3: group 'SG-II'")) << err_;
}

TEST_F(Cli, GoesOnAfterARowThatFailsWhenItIsTold) {
  write("locks.json", locks);
  // In degrees it locks beyond 36.9; rows are in radians.
  write("rows", "# t theta\n");
  EXPECT_EQ(desmo("solve locks.json --drivers rows"), 65);
  write("rows", "0 0 1 0\n0.1 0.1 1 0\n\n0.2 1 1 0\n0.3 0.2 1 0\n0.3 0.3 1 0\n0.4 nan 1 0\n");
  EXPECT_EQ(desmo("solve locks.json --drivers rows"), 1);
  EXPECT_TRUE(says("rows: line 4: group 'SG-II'") && says("no position was found")) << err_;
  EXPECT_EQ(lines().size(), 3u);
  ASSERT_EQ(desmo("solve locks.json --drivers rows --past-failures"), 0) << err_;
  EXPECT_TRUE(says("line 6: t = 0.3 s is not after")) << err_;
  EXPECT_TRUE(says("line 7: a number is not finite") && says("not solved: 3 rows")) << err_;
  const std::vector<std::string> answers = lines();
  ASSERT_EQ(answers.size(), 7u);
  for (const auto& [line, outcome] : std::initializer_list<std::pair<int, std::string>>{
           {1, "converged"}, {3, "failed"}, {4, "converged"}, {5, "refused"}, {6, "refused"}})
    EXPECT_TRUE(answers[line].ends_with("," + outcome)) << answers[line];
  EXPECT_TRUE(answers[3].starts_with("0.2,,,")) << answers[3];
}

TEST_F(Cli, NamesLineAndColumnOfARowThatCannotBeRead) {
  for (const auto& [rows, message] : std::initializer_list<std::pair<std::string, std::string>>{
           {"0,0,1,0\n1,0,1,0\n2,0,one,0\n", "line 3, column 3: 'one' is not a number"},
           {"0,0,1,0\n1,0,1\n", "line 2, column 4: 3 numbers, where 4 are expected"},
           {"0,0,1\n", "line 1, column 4: 3 numbers, where 4 are needed; write t,theta,d/dt theta"},
           {"t,theta,d/dt theta\n", "line 1, column 1: there is no column 'd2/dt2 theta'"},
           {"theta,d/dt theta,d2/dt2 theta\n", "line 1, column 1: there is no column t"},
           {"0;0;1;0\n", "line 1, column 1: there is no column t"},
           {"0,0,1,0\n1;0,1,0,0\n", "line 2, column 1: '1;0' is not a number"},
           {"t [s],theta [deg]\n", "line 1, column 2: 'theta [deg]': the unit is rad"},
           {"t,theta,theta\n", "line 1, column 3: 'theta' stands there twice"}}) {
    write("rows", rows);
    EXPECT_EQ(desmo("solve slider_crank --drivers rows"), 65) << rows;
    EXPECT_TRUE(says("rows: " + message)) << err_;
  }
  EXPECT_EQ(desmo("solve slider_crank --drivers none"), 66);
  EXPECT_EQ(desmo("solve - --drivers -"), 64);
  EXPECT_EQ(desmo("solve slider_crank --drivers rows --formulation "
                  "group_symbolic_explicit/threads:2"),
            64);
  EXPECT_TRUE(says("need a motion known in advance")) << err_;
}

}  // namespace
}  // namespace desmo::live_test
