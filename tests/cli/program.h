// A fixture that runs the program desmo as a user does, and reads its output and files.
#pragma once

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "tests/replaced.h"
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

/// Returns the scene of a slider-crank whose driver is another coordinate, s. definition: what it
/// measures; unit: of its motion's lengths.
inline std::string driven_by_s(const std::string& scene, const std::string& definition,
                               const std::string& unit, const std::string& motion) {
  const std::string defined =
      replaced(scene, R"("theta": {"angle": ["A", "B"]})", "\"s\": " + definition);
  return replaced(replaced(defined, R"(["theta"])", R"(["s"])"), R"("units": {"angle": "deg"},
  "motion": {"theta": {"type": "polynomial", "coefficients": [0, 360]}})",
                  "\"units\": {\"length\": \"" + unit + "\"}, \"motion\": {\"s\": " + motion + "}");
}

/// Returns the scene of a slider-crank in millimetres, drawn at 180 mm, whose slider is driven.
inline std::string driven_slider(const std::string& motion) {
  return driven_by_s(replaced(slider_crank(150, R"(, "time": {"end": 1, "step": 0.5})"),
                              R"("B": [50, 0], "C": [200, 0])", R"("B": [30, 40], "C": [180, 0])"),
                     R"({"distance": ["A", "C"], "along": "x"})", "mm", motion);
}

/// Returns the scene of a slider-crank that measures the distance of C, drawn at [200, 0], from a
/// point of the ground.
inline std::string measured_distance(const std::string& point) {
  std::string scene = slider_crank(150, R"(, "time": {"end": 0.1, "step": 0.1})");
  for (const auto& [old, by] : std::initializer_list<std::pair<const char*, std::string>>{
           {R"("A": [0, 0],)", R"("A": [0, 0], "P": )" + point + ","},
           {R"("ground": {"points": ["A"])", R"("ground": {"points": ["A", "P"])"},
           {R"("theta": {"angle")", R"("d": {"distance": ["P", "C"]}, "theta": {"angle")"}})
    scene = replaced(scene, old, by);
  return scene;
}

/// A slider-crank whose rod is too short for a full turn: it locks at the crank angle asin(30/50).
inline const std::string locks = slider_crank(30, R"(, "time": {"end": 1, "step": 0.01})");

/// A fixture that runs the program in a temporary folder, where its cache is, too.
class Cli : public InFolder {
 protected:
  using Json = nlohmann::json;

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

  /// Return what a run prints, which succeeds: its text, lines or JSON. Throw std::runtime_error
  /// with what it says where it fails.
  std::string printed(const std::string& arguments) {
    if (desmo(arguments) != 0) throw std::runtime_error("desmo " + arguments + ": " + err_);
    return out_;
  }
  std::vector<std::string> lines_of(const std::string& arguments) {
    printed(arguments);
    return lines();
  }
  Json json_of(const std::string& arguments) { return Json::parse(printed(arguments)); }

  /// Expects an exit code, and messages on standard error.
  void expect_said(int code, const std::string& arguments, const auto&... messages) {
    EXPECT_EQ(desmo(arguments), code) << arguments << err_;
    for (const std::string& message : {std::string(messages)...})
      EXPECT_TRUE(says(message)) << arguments << " says " << err_ << "instead of " << message;
  }
  /// Expects success, and texts on standard output.
  void expect_printed(const std::string& arguments, const auto&... texts) {
    EXPECT_EQ(desmo(arguments), 0) << arguments << err_;
    for (const std::string& text : {std::string(texts)...})
      EXPECT_TRUE(prints(text)) << arguments << " prints " << out_ << "instead of " << text;
  }
  /// Starts a command in the folder that never ends, and sends it a signal as soon as it has begun
  /// what it is to be interrupted at. Returns its exit code.
  int interrupt(const std::string& command, int signal, const auto& has_begun) {
    const pid_t child = ::fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) {
      ::signal(signal, SIG_DFL);
      const std::string there = "cd '" + folder_.string() + "' && exec " + command;
      ::execl("/bin/sh", "sh", "-c", there.c_str(), nullptr);
      ::_exit(127);
    }
    EXPECT_TRUE(comes_true(has_begun));
    ::kill(child, signal);
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return exit_code(status);
  }
  /// Waits up to two minutes for a condition. Returns whether it holds.
  static bool comes_true(const auto& condition) {
    for (int i = 0; i < 12000 && !condition(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return condition();
  }

  bool says(const std::string& text) const { return err_.find(text) != std::string::npos; }
  bool prints(const std::string& text) const { return out_.find(text) != std::string::npos; }
  std::vector<std::string> lines() const {
    std::vector<std::string> result;
    std::istringstream in(out_);
    for (std::string line; std::getline(in, line);) result.push_back(line);
    return result;
  }
  static std::vector<std::string> cells(const std::string& csv_line) {
    std::vector<std::string> result;
    std::istringstream in(csv_line);
    for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
    return result;
  }
  static std::vector<double> numbers(const std::string& csv_line) {
    std::vector<double> result;
    for (const std::string& cell : cells(csv_line)) result.push_back(std::stod(cell));
    return result;
  }
  /// Returns the numbers of a row of CSV or JSON lines, its last column excepted.
  static std::vector<double> numbers_before_last(const std::string& row) {
    const std::size_t begin = row.front() == '[';
    return numbers(row.substr(begin, row.rfind(',') - begin));
  }
  /// Expects the printed rows to be others up to 1e-9, relative where numbers are large.
  void expect_rows(const std::vector<std::string>& expected) const {
    const std::vector<std::string> found = lines();
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(found[0], expected[0]);
    for (std::size_t i = 1; i < found.size(); ++i) {
      const std::vector<double> x = numbers(found[i]), y = numbers(expected[i]);
      ASSERT_EQ(x.size(), y.size());
      for (std::size_t k = 0; k < x.size(); ++k)
        EXPECT_NEAR(x[k], y[k], 1e-9 * std::max(1.0, std::abs(y[k]))) << i << ", " << k;
    }
  }
};

}  // namespace desmo
