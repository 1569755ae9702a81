// A fixture that runs the program desmo as a user does, and reads its output and files.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/started.h"

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

/// A fixture that runs the program in a temporary folder, where its cache is, too.
class Cli : public InFolder {
 protected:
  Cli() {
    std::filesystem::create_directory(folder_ / "out");
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
  }
  ~Cli() override { ::unsetenv("XDG_CACHE_HOME"); }

  std::filesystem::path out(const std::string& name) const { return folder_ / "out" / name; }

  /// Runs a shell command in the folder; its streams end up in out_ and err_.
  int shell(const std::string& command) {
    return InFolder::shell("cd '" + folder_.string() + "' && { " + command + "; }");
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
};

}  // namespace desmo
