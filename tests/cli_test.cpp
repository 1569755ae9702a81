// The program desmo as a user runs it: what it prints and writes, its messages and exit codes.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <thread>

#include "cases/library.h"

namespace desmo {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A slider-crank that is driven by its slider or crank; the crank is 50 long.
std::string slider_crank(int rod, const std::string& rest) {
  const std::string end = std::to_string(50 + rod);
  return R"({"format": "desmo-scene", "version": 1, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "short", "dimension": 2,
    "units": {"length": "mm", "angle": "deg"},
    "points": {"A": [0, 0], "B": [50, 0], "C": [)" +
         end + R"(, 0]}, "vectors": {"x": [1, 0]},
    "ground": {"points": ["A"], "vectors": ["x"]},
    "bodies": {"crank": {"points": ["A", "B"]}, "rod": {"points": ["B", "C"]},
               "slider": {"points": ["C"], "vectors": ["x"]}},
    "joints": [
      {"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
      {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
      {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
      {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"], "points": ["A", "C"]}],
    "coordinates": {"theta": {"angle": ["A", "B"]}}, "drivers": ["theta"]},
  "units": {"angle": "deg"},
  "motion": {"theta": {"type": "polynomial", "coefficients": [0, 360]}})" +
         rest + "}";
}

/// Its rod is too short for a whole turn: it locks after asin(30/50).
const std::string locks = slider_crank(30, R"(, "time": {"end": 1, "step": 0.01})");
/// More than anybody waits for.
const std::string endless = slider_crank(150, R"(, "time": {"end": 5000, "step": 0.00001})");

class Cli : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "desmo_cli_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    fs::create_directory(folder_ / "out");
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  fs::path out(const std::string& name) const { return folder_ / "out" / name; }

  /// Runs a shell command in the folder; its streams end up in out_ and err_.
  int shell(const std::string& command) {
    const std::string to =
        " >" + (folder_ / "stdout").string() + " 2>" + (folder_ / "stderr").string();
    const int status =
        std::system(("cd " + folder_.string() + " && { " + command + "; }" + to).c_str());
    out_ = text_of(folder_ / "stdout");
    err_ = text_of(folder_ / "stderr");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int desmo(const std::string& arguments) { return shell(DESMO_CLI " " + arguments); }

  bool says(const std::string& text) const { return err_.find(text) != std::string::npos; }
  bool prints(const std::string& text) const { return out_.find(text) != std::string::npos; }
  std::vector<std::string> lines() const {
    std::vector<std::string> result;
    std::istringstream in(out_);
    for (std::string line; std::getline(in, line);) result.push_back(line);
    return result;
  }
  static std::vector<double> numbers(const std::string& csv_line) {
    std::vector<double> result;
    std::istringstream in(csv_line);
    for (std::string cell; std::getline(in, cell, ',');) result.push_back(std::stod(cell));
    return result;
  }

  /// Starts a run that never ends, and interrupts it when its output has begun to grow.
  int interrupt(int signal) {
    write("endless.json", endless);
    const pid_t child = fork();
    if (child == 0) {
      ::signal(signal, SIG_DFL);
      execl(DESMO_CLI, DESMO_CLI, "solve", (folder_ / "endless.json").c_str(), "--quiet", "-o",
            out("motion.csv").c_str(), nullptr);
      _exit(127);
    }
    const auto grows = [&] {
      return std::ranges::any_of(fs::directory_iterator(folder_ / "out"), [](const auto& entry) {
        return entry.path().filename() != "motion.csv" && entry.file_size() > 0;
      });
    };
    for (int i = 0; i < 6000 && !grows(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(grows());
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path folder_;
  std::string out_, err_;
};

TEST_F(Cli, ListsWhatThereIs) {
  ASSERT_EQ(desmo("list"), 0) << err_;
  ASSERT_FALSE(library().empty());
  for (const LibraryMechanism& m : library()) EXPECT_TRUE(prints("  " + std::string(m.name) + " "));
  EXPECT_TRUE(prints("truck_suspension"));
  EXPECT_TRUE(prints("block_symbolic_inlined"));

  ASSERT_EQ(desmo("list --json"), 0);
  const Json all = Json::parse(out_);
  EXPECT_EQ(all["mechanisms"].size(), library().size());
  EXPECT_EQ(all["cases"].size(), 2u);
  EXPECT_GT(all["formulations"].size(), 10u);
  const auto crank = std::ranges::find_if(
      all["mechanisms"], [](const Json& m) { return m["name"] == "slider_crank"; });
  ASSERT_NE(crank, all["mechanisms"].end());
  EXPECT_EQ((*crank)["bodies"], 3);
  EXPECT_EQ((*crank)["degrees_of_freedom"], 1);
  EXPECT_EQ((*crank)["dimension"], 2);

  ASSERT_EQ(desmo("list cases"), 0);
  EXPECT_TRUE(prints("four_bar"));
  EXPECT_FALSE(prints("slider_crank"));
  EXPECT_EQ(desmo("list dogs"), 64);
}

TEST_F(Cli, ShowsWhatIsThenReadBack) {
  for (const LibraryMechanism& m : library()) {
    const std::string name(m.name);
    ASSERT_EQ(desmo("show " + name + " >mechanism.json"), 0);
    ASSERT_EQ(desmo("show " + name + " --scene >scene.json"), 0);
    EXPECT_EQ(text_of(folder_ / "mechanism.json"), m.mechanism);
    EXPECT_EQ(desmo("inspect mechanism.json"), 0) << err_;
    const std::string from_mechanism = out_;
    EXPECT_EQ(desmo("inspect scene.json"), 0) << err_;
    EXPECT_EQ(out_, from_mechanism);
    EXPECT_EQ(desmo("inspect - <scene.json"), 0) << err_;
    EXPECT_EQ(out_, from_mechanism);
    EXPECT_EQ(desmo("inspect " + name), 0) << err_;
    EXPECT_EQ(out_, from_mechanism);
  }
}

TEST_F(Cli, InspectsTheStructureOfTheTruck) {
  ASSERT_EQ(desmo("inspect truck_suspension:1"), 0) << err_;
  for (const char* text :
       {"114 coordinates: 112 dependent, 2 independent (axle1/zL, axle1/zR)",
        "axle1/SG-I (4, 2)\n    bodies        axle1/2, axle1/3, axle1/4, axle1/5\n",
        "axle1/SG-II (2, 0)", "axle1/SG-V (2, 0)", "bodies        axle1/12, axle1/13",
        "16 + 6×3 + 5×1", "Constant parts, solved once: 1", "12 moving bodies, 18 joints"})
    EXPECT_TRUE(prints(text)) << text << "\n" << out_;

  ASSERT_EQ(desmo("inspect truck_suspension:2 --json"), 0);
  const Json all = Json::parse(out_);
  EXPECT_EQ(all["coordinates"]["all"], 2 * 111 + 3);
  EXPECT_EQ(all["coordinates"]["independent"].size(), 4u);
  EXPECT_EQ(all["constant_parts"], 1);
  EXPECT_EQ(all["groups"].size(), 11u);
  for (const Json& group : all["groups"]) {
    std::size_t unknowns = 0, equations = 0;
    for (const Json& block : group["blocks"]) {
      unknowns += block["unknowns"].size();
      for (const Json& equation : block["equations"]) equations += equation["rows"].size();
    }
    EXPECT_EQ(unknowns, group["unknowns"]);
    EXPECT_EQ(equations, unknowns);
  }
  EXPECT_EQ(all["groups"][2]["after"], Json{"axle1/SG-I"});
  EXPECT_EQ(all["groups"][2]["on_ground"], true);
}

TEST_F(Cli, MarksRedundantConstraints) {
  write("twins.json", R"({"format": "desmo-mechanism", "version": 1, "name": "twins",
    "dimension": 2,
    "points": {"A": [0, 0], "B": [1, 2], "C": [4, 2], "D": [3, 0], "E": [1.5, 0], "F": [2.5, 2]},
    "ground": {"points": ["A", "D", "E"]},
    "bodies": {"a": {"points": ["A", "B"]}, "b": {"points": ["B", "C", "F"]},
               "c": {"points": ["D", "C"]}, "d": {"points": ["E", "F"]}},
    "joints": [
      {"type": "revolute", "bodies": ["ground", "a"], "points": ["A"]},
      {"type": "revolute", "bodies": ["ground", "c"], "points": ["D"]},
      {"type": "revolute", "bodies": ["ground", "d"], "points": ["E"]},
      {"type": "revolute", "bodies": ["a", "b"], "points": ["B"]},
      {"type": "revolute", "bodies": ["c", "b"], "points": ["C"]},
      {"type": "revolute", "bodies": ["d", "b"], "points": ["F"]}],
    "coordinates": {"theta": {"angle": ["A", "B"]}}, "drivers": ["theta"]})");
  ASSERT_EQ(desmo("inspect twins.json"), 0) << err_;
  EXPECT_TRUE(prints("redundant but consistent: accepted")) << out_;
  ASSERT_EQ(desmo("inspect twins.json --json"), 0);
  const Json left_out = Json::parse(out_)["left_out"];
  EXPECT_TRUE(std::ranges::any_of(left_out, [](const Json& l) { return l["redundant"] == true; }));
}

TEST_F(Cli, SolvesAnAngleThatIsMeasuredTwice) {
  write("back.json", R"({"format": "desmo-scene", "version": 1, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "crank", "dimension": 2,
    "points": {"A": [0, 0], "B": [0.6, 0.8]}, "ground": {"points": ["A"]},
    "bodies": {"crank": {"points": ["A", "B"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]}],
    "coordinates": {"theta": {"angle": ["A", "B"]}, "back": {"angle": ["B", "A"]}},
    "drivers": ["theta"]},
    "motion": {"theta": {"type": "polynomial", "coefficients": [0.9272952180016123, 6.3]}},
    "time": {"end": 1, "step": 0.01},
    "request": [{"angles": ["theta", "back"], "level": "velocity"}]})");
  ASSERT_EQ(desmo("solve back.json --format jsonl"), 0) << err_;
  std::istringstream lines(out_);
  std::string line;
  std::getline(lines, line);
  const Json columns = Json::parse(line)["columns"];
  const auto column = [&](const char* name) {
    return std::ranges::find(columns, name, [](const Json& c) { return c["name"]; }) -
           columns.begin();
  };
  int instants = 0;
  for (; std::getline(lines, line); ++instants) {
    const Json values = Json::parse(line);
    const double turned =
        values[column("back")].get<double>() - values[column("theta")].get<double>();
    EXPECT_NEAR(std::abs(std::remainder(turned, 2 * std::numbers::pi)), std::numbers::pi, 1e-9);
    EXPECT_NEAR(values[column("d/dt back")].get<double>(), 6.3, 1e-9) << line;
  }
  EXPECT_EQ(instants, 101);
}

/// Steps of three quarters of a turn end where the angle is half a turn away from the one driven.
TEST_F(Cli, RefusesToTellAPositionOnAnotherBranch) {
  write("leap.json", R"({"format": "desmo-scene", "version": 1, "mechanism": {"library": "rssr"},
    "motion": {"theta": {"type": "polynomial", "coefficients": [0.5, 1]}},
    "time": {"end": 5, "step": 2.5}, "request": [{"points": ["A"]}]})");
  EXPECT_EQ(desmo("solve leap.json -o out/leap.csv"), 1);
  EXPECT_TRUE(says("turns away")) << err_;
  EXPECT_FALSE(fs::exists(out("leap.csv")));
}

TEST_F(Cli, DrawsTheStructuralDiagram) {
  ASSERT_EQ(desmo("inspect truck_suspension:1 --diagram -"), 0) << err_;
  for (const char* text : {"digraph \"truck_suspension\" {", "ground [label=\"0\"];",
                           "g1 [label=\"(4, 2)\\naxle1/SG-I\\n{2, 3, 4, 5}\"];",
                           "g5 [label=\"(2, 0)\\n", "ground -> g1;", "g1 -> g5;", "ground -> g5;"})
    EXPECT_TRUE(prints(text)) << text << "\n" << out_;
  EXPECT_FALSE(prints("g2 -> g3"));
  EXPECT_FALSE(prints("g0"));  // what is constant is no group
  const std::string dot = out_;
  ASSERT_EQ(desmo("inspect truck_suspension:1 --diagram out/truck.dot"), 0);
  EXPECT_EQ(text_of(out("truck.dot")), dot);
  EXPECT_TRUE(prints("axle1/SG-I (4, 2)"));
}

TEST_F(Cli, DrawsSvgByGraphviz) {
  fs::create_directory(folder_ / "programs");
  const std::string path = "PATH=" + (folder_ / "programs").string() + " ";
  const std::string draw = path + DESMO_CLI " inspect slider_crank --diagram out/a.svg";
  EXPECT_EQ(shell(draw), 69);
  EXPECT_TRUE(says("apt-get install graphviz")) << err_;
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));

  const auto install = [&](const std::string& script) {
    write("programs/dot", "#!/bin/sh\n" + script);
    fs::permissions(folder_ / "programs/dot", fs::perms::owner_all);
  };
  install("echo half; exit 1\n");
  EXPECT_EQ(shell(draw), 69);
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  install("echo \"<svg $1>\"; while read -r line; do echo \"$line\"; done\n");
  EXPECT_EQ(shell(draw), 0) << err_;
  EXPECT_TRUE(text_of(out("a.svg")).starts_with("<svg -Tsvg>\ndigraph \"slider_crank\" {\n"));
  EXPECT_EQ(desmo("inspect slider_crank --diagram a.png"), 64);
  EXPECT_EQ(desmo("inspect slider_crank --json --diagram -"), 64);
}

TEST_F(Cli, SolvesToTheSameNumbersInEitherFormat) {
  ASSERT_EQ(desmo("solve slider_crank --quiet"), 0) << err_;
  EXPECT_EQ(err_, "");
  const std::vector<std::string> csv = lines();
  ASSERT_EQ(csv.size(), 402u);
  EXPECT_TRUE(csv[0].starts_with("t [s],")) << csv[0];
  for (const char* name : {"C.x [m]", "d/dt C.x [m/s]", "d2/dt2 C.x [m/s^2]", "theta [rad]",
                           "d/dt theta [rad/s]", "d2/dt2 phi [rad/s^2]", "s [m]"})
    EXPECT_NE((csv[0] + ",").find("," + std::string(name) + ","), std::string::npos) << name;

  ASSERT_EQ(desmo("solve slider_crank --quiet -o out/motion.jsonl"), 0) << err_;
  out_ = text_of(out("motion.jsonl"));
  const std::vector<std::string> jsonl = lines();
  ASSERT_EQ(jsonl.size(), csv.size());
  const Json heading = Json::parse(jsonl[0]);
  EXPECT_EQ(heading["mechanism"], "slider_crank");
  std::string names;
  for (const Json& column : heading["columns"])
    names += (names.empty() ? "" : ",") + column["name"].get<std::string>() + " [" +
             column["unit"].get<std::string>() + "]";
  EXPECT_EQ(names, csv[0]);
  for (std::size_t i = 1; i < csv.size(); ++i)
    EXPECT_EQ(Json::parse(jsonl[i]).get<std::vector<double>>(), numbers(csv[i]));

  // After a quarter turn the crank, 0.05 m, stands upright; the rod has 0.15 m.
  const std::vector<double> quarter = numbers(csv[1 + 100]);
  std::istringstream header(csv[0]);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(header, cell, ',');) cells.push_back(cell);
  const auto value = [&](const std::string& name) {
    return quarter[std::ranges::find(cells, name) - cells.begin()];
  };
  EXPECT_NEAR(value("t [s]"), 0.25, 1e-15);
  EXPECT_NEAR(value("B.y [m]"), 0.05, 1e-12);
  EXPECT_NEAR(value("s [m]"), std::sqrt(0.15 * 0.15 - 0.05 * 0.05), 1e-12);
}

TEST_F(Cli, EveryFormulationGivesTheSameAnswer) {
  ASSERT_EQ(desmo("list formulations --json"), 0);
  const Json formulations = Json::parse(out_)["formulations"];
  const std::string scene = slider_crank(150, R"(, "time": {"end": 0.2, "step": 0.1},
    "request": [{"points": ["C"], "level": "acceleration"}], "tolerance": 1e-13)");
  write("scene.json", scene);
  std::vector<double> expected;
  for (const Json& f : formulations) {
    ASSERT_EQ(desmo("solve scene.json --formulation " + f["id"].get<std::string>()), 0) << err_;
    const std::vector<double> last = numbers(lines().back());
    if (expected.empty()) expected = last;
    ASSERT_EQ(last.size(), expected.size());
    for (std::size_t i = 0; i < last.size(); ++i) EXPECT_NEAR(last[i], expected[i], 1e-9) << f;
  }
}

TEST_F(Cli, DeliversOnlyWhatIsAskedFor) {
  const auto solve = [&](const std::string& request) {
    write("scene.json",
          slider_crank(150, R"(, "time": {"end": 1, "step": 0.1}, "request": [)" + request + "]"));
    EXPECT_EQ(desmo("solve scene.json --quiet"), 0) << err_;
    EXPECT_EQ(lines().size(), 12u);
    EXPECT_EQ(numbers(lines().back()).size(),
              static_cast<std::size_t>(std::ranges::count(lines().front(), ',') + 1));
    return lines().front();
  };
  EXPECT_EQ(solve(R"({"points": ["C"]})"), "t [s],C.x [m],C.y [m]");
  EXPECT_EQ(solve(R"({"points": ["B"], "level": "velocity"}, {"angles": ["theta"]})"),
            "t [s],B.x [m],B.y [m],d/dt B.x [m/s],d/dt B.y [m/s],theta [rad]");
  EXPECT_EQ(solve(R"({"angles": ["theta"], "level": "acceleration"})"),
            "t [s],theta [rad],d/dt theta [rad/s],d2/dt2 theta [rad/s^2]");
  // What never moves is delivered when it is asked for by name.
  EXPECT_EQ(solve(R"({"points": ["A"], "vectors": ["x"], "level": "velocity"})"),
            "t [s],A.x [m],A.y [m],d/dt A.x [m/s],d/dt A.y [m/s],x.x [-],x.y [-],d/dt x.x [1/s],"
            "d/dt x.y [1/s]");
  EXPECT_EQ(numbers(lines().back()), (std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0}));
  ASSERT_EQ(desmo("solve jansen_leg --quiet"), 0);
  EXPECT_TRUE(prints("F.x [1],F.y [1],d/dt F.x [1/s]")) << lines().front();
}

TEST_F(Cli, ExplainsWhatIsNotSolved) {
  write("scene.json", R"({"format": "desmo-scene", "version": 1,
    "mechanism": {"generator": "truck_suspension", "axles": 2}, "time": {"end": 0.1, "step": 0.1},
    "request": [{"points": ["axle1/S"], "level": "velocity"}]})");
  ASSERT_EQ(desmo("solve scene.json --explain"), 0) << err_;
  for (const char* text :
       {" of 221 unknowns, 2 of 4 drivers", "to velocity", "serves axle1/S",
        "groups not needed: axle1/SG-II", "dropped: ", "drivers not needed: axle2/zL, axle2/zR"})
    EXPECT_TRUE(says(text)) << text << "\n" << err_;
  EXPECT_EQ(lines().size(), 3u);
  ASSERT_EQ(desmo("solve slider_crank --explain --quiet"), 0);
  EXPECT_TRUE(says("solved: 8 of 8 unknowns, 1 of 1 driver")) << err_;
}

TEST_F(Cli, ReadsScenesFromStandardInput) {
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1})"));
  ASSERT_EQ(desmo("solve scene.json --quiet"), 0) << err_;
  const std::string expected = out_;
  ASSERT_EQ(desmo("solve - --quiet <scene.json"), 0) << err_;
  EXPECT_EQ(out_, expected);
  ASSERT_EQ(desmo("solve - --quiet -o - <scene.json"), 0) << err_;
  EXPECT_EQ(out_, expected);
}

TEST_F(Cli, FailedRunsNameThePlaceAndLeaveNothing) {
  write("locks.json", locks);
  EXPECT_EQ(desmo("solve locks.json -o out/motion.csv"), 1);
  // 11 instants are within reach: it locks at 0.1024 s.
  for (const char* text :
       {"desmo: locks.json: group 'SG-II' (rod, slider), constraint '", "t = 0.11 s", "; "})
    EXPECT_TRUE(says(text)) << err_;
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  std::ofstream(out("motion.csv")) << "kept";
  EXPECT_EQ(desmo("solve locks.json -o out/motion.csv"), 1);
  EXPECT_EQ(text_of(out("motion.csv")), "kept");

  EXPECT_EQ(desmo("solve locks.json"), 1);
  EXPECT_EQ(lines().size(), 12u);
  EXPECT_TRUE(says("instants before it, on standard output: 11")) << err_;
}

TEST_F(Cli, InterruptedRunsLeaveNothing) {
  EXPECT_EQ(interrupt(SIGINT), 130);
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  std::ofstream(out("motion.csv")) << "kept";
  EXPECT_EQ(interrupt(SIGTERM), 143);
  EXPECT_EQ(text_of(out("motion.csv")), "kept");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 1);
}

TEST_F(Cli, OutputThatCannotBeWritten) {
  EXPECT_EQ(desmo("solve slider_crank -o /dev/full"), 74);
  EXPECT_TRUE(says("/dev/full: cannot be written (No space left on device)")) << err_;
  EXPECT_EQ(desmo("solve slider_crank >/dev/full"), 74);
  EXPECT_EQ(desmo("list >/dev/full"), 74);
  EXPECT_EQ(desmo("--help >/dev/full"), 74);
  EXPECT_EQ(desmo("solve slider_crank >&-"), 74);
  EXPECT_EQ(desmo("inspect slider_crank --diagram /nonexistent/a.dot"), 74);
  EXPECT_EQ(desmo("solve slider_crank -o nowhere/motion.csv"), 74);
  EXPECT_TRUE(says("desmo: nowhere/motion.csv: cannot be written")) << err_;
  EXPECT_EQ(desmo("solve slider_crank -o out"), 74);
  EXPECT_EQ(desmo("solve slider_crank -o ''"), 64);
  // No file may grow beyond 8 blocks: as on a full disk.
  EXPECT_EQ(
      shell("sh -c 'ulimit -f 8; exec " DESMO_CLI " solve slider_crank --quiet -o out/motion.csv'"),
      74);
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  EXPECT_EQ(desmo("solve slider_crank --quiet -o /dev/null"), 0);
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(Cli, WritesThroughLinksAndKeepsPermissions) {
  std::ofstream(out("real.csv")) << "old";
  fs::permissions(out("real.csv"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.csv", out("link.csv"));
  ASSERT_EQ(desmo("solve slider_crank --quiet -o out/link.csv"), 0) << err_;
  EXPECT_TRUE(fs::is_symlink(out("link.csv")));
  EXPECT_TRUE(text_of(out("real.csv")).starts_with("t [s],"));
  EXPECT_EQ(fs::status(out("real.csv")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Cli, EndsQuietlyWhenNobodyReads) {
  EXPECT_EQ(shell("{ " DESMO_CLI " solve four_bar:40 --quiet; echo $? >code; } | head -n 1"), 0);
  EXPECT_EQ(text_of(folder_ / "code"), "141\n");
  EXPECT_EQ(err_, "");
}

TEST_F(Cli, InputThatIsWrong) {
  EXPECT_EQ(desmo("solve nowhere.json"), 66);
  EXPECT_TRUE(says("desmo: nowhere.json: there is no such file")) << err_;
  EXPECT_EQ(desmo("solve ."), 66);
  EXPECT_EQ(desmo("inspect slider_crnk"), 66);
  EXPECT_TRUE(says("did you mean 'slider_crank'?")) << err_;
  EXPECT_EQ(desmo("show slider_crnk"), 64);
  EXPECT_TRUE(says("did you mean 'slider_crank'?")) << err_;

  write("half.json", locks.substr(0, 300));
  EXPECT_EQ(desmo("solve half.json"), 65);
  EXPECT_TRUE(says("desmo: half.json: line ")) << err_;
  EXPECT_EQ(desmo("inspect half.json"), 65);
  write("list.json", "[1]");
  EXPECT_EQ(desmo("inspect list.json"), 65);
  EXPECT_EQ(desmo("solve - </dev/null"), 65);
  EXPECT_TRUE(says("desmo: standard input: ")) << err_;
  ASSERT_EQ(desmo("show slider_crank >mechanism.json"), 0);
  EXPECT_EQ(desmo("solve mechanism.json"), 65);
  EXPECT_TRUE(says("says nothing of motion")) << err_;

  std::string loose = locks;
  loose.replace(loose.find(R"("drivers": ["theta"])"), 20, R"("drivers": [])");
  loose.replace(loose.find(R"("motion")"), std::string::npos,
                R"("time": {"end": 1, "step": 0.1}})");
  write("loose.json", loose);
  EXPECT_EQ(desmo("inspect loose.json"), 65);
  EXPECT_TRUE(says("desmo: loose.json: ") && says("under-constrained") && says("add a driver"))
      << err_;
}

TEST_F(Cli, UsageErrors) {
  EXPECT_EQ(desmo(""), 64);
  EXPECT_EQ(desmo("inspekt slider_crank"), 64);
  EXPECT_TRUE(says("did you mean 'inspect'?")) << err_;
  EXPECT_EQ(desmo("solve"), 64);
  EXPECT_EQ(desmo("solve slider_crank --no-such-option"), 64);
  EXPECT_EQ(desmo("solve slider_crank --format xml"), 64);
  EXPECT_EQ(desmo("solve truck_suspension"), 64);
  EXPECT_EQ(desmo("solve truck_suspension:0"), 64);
  EXPECT_EQ(desmo("solve truck_suspension:1x"), 64);
  EXPECT_EQ(desmo("solve slider_crank --formulation group_symbolic_kul"), 64);
  EXPECT_TRUE(says("did you mean 'group_symbolic_klu'?")) << err_;
  EXPECT_EQ(out_, "");
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1},
                                            "formulation": "magic")"));
  EXPECT_EQ(desmo("solve scene.json"), 65);
  EXPECT_TRUE(says("desmo: scene.json: /formulation: unknown formulation 'magic'")) << err_;
  EXPECT_EQ(desmo("--help"), 0);
  EXPECT_TRUE(prints("inspect") && prints("Exit codes"));
  EXPECT_EQ(desmo("solve --help"), 0);
  EXPECT_EQ(desmo("--version"), 0);
  EXPECT_TRUE(out_.starts_with("desmo ")) << out_;
}

}  // namespace
}  // namespace desmo
