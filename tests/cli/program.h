// A fixture that runs the program desmo as a user does, and reads its output and files.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace desmo {

/// Returns the scene of a slider-crank with a driven crank of 50 mm. rod: length of the rod [mm].
/// rest: further members of the scene.
inline std::string slider_crank(int rod, const std::string& rest) {
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

/// A slider-crank whose rod is too short for a full turn: it locks at the crank angle asin(30/50).
inline const std::string locks = slider_crank(30, R"(, "time": {"end": 1, "step": 0.01})");
/// A fixture that runs the program in a temporary folder.
class Cli : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "desmo_cli_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    std::filesystem::create_directory(folder_ / "out");
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("XDG_CACHE_HOME");
    std::filesystem::remove_all(folder_);
  }

  static std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  std::filesystem::path out(const std::string& name) const { return folder_ / "out" / name; }

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

  std::filesystem::path folder_;
  std::string out_, err_;
};

}  // namespace desmo
