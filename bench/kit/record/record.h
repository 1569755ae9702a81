#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/kit/record/environment.h"
#include "bench/kit/time/timing_windows.h"
#include "bench/kit/verification.h"
#include "cases/io/new_files.h"
#include "cases/mechanism/motion.h"

namespace desmo::bench {

/// Version of results/record.schema.json and results/check.schema.json that is written.
inline constexpr const char* schema_version = "3.0.0";

/// A writer of one record. Its constructor opens the file before anything is measured, so that an
/// unusable path is found at once. write() is called once, after all measurements.
class RecordWriter {
 public:
  /// Notes date and load, and takes the file (see OutputFile). command: program name and arguments.
  /// experiment: the name of the section that is written.
  /// Throws OutputError, and std::invalid_argument for an empty path.
  RecordWriter(const std::string& path, const std::string& command, const std::string& experiment);

  /// Notes the load and writes lists to the file, once. Throws OutputError.
  ///
  /// grid: for the settings, the usual one where there are several.
  /// lists: an object of arrays; empty ones are left out.
  /// windows: timing windows into which motions were cut, where they were.
  void write(const TimeGrid& grid, const nlohmann::ordered_json& lists,
             std::optional<int> windows = {});

 private:
  OutputFile file_;
  Run run_;
  const std::string experiment_;
};

/// Returns the head of a record that has no samples: what was measured where, now.
nlohmann::ordered_json record_head(const std::string& command, const TimeGrid& grid);

/// Returns the text of a record: its head indented, and an element of a list on each line, as a
/// person may want to read the one and not the other.
///
/// head: an object with something in it.
/// sections: an object of objects of arrays.
std::string record_layout(const nlohmann::ordered_json& head,
                          const nlohmann::ordered_json& sections);

/// Returns a value by the names of the levels.
nlohmann::ordered_json per_level_json(const PerLevel<double>& values);

/// Returns `verification` of a candidate, down to a level: others were not compared.
nlohmann::ordered_json errors_json(const Differences& errors, Level level = Level::acceleration);

/// Returns samples of a time [s] with the clock that they are of.
nlohmann::ordered_json time_json(const std::vector<double>& seconds, Clock clock = Clock::cpu);

/// Returns samples of CPU time [s], rounded to five digits: there are many, and no machine repeats
/// more.
nlohmann::ordered_json rounded_time_json(const std::vector<double>& seconds);

/// Returns the timing windows of a time: of every analysis, and the work in each; their least alone
/// where nobody counts the work.
nlohmann::ordered_json windows_json(const TimingWindows& windows);

/// Returns a value rounded to significant digits, and at most 1e100: an infinite error is no
/// number of JSON's.
double rounded(double value, int digits);

/// Returns the name of a clock in a record: "cpu" or "wall".
const char* clock_name(Clock clock);

}  // namespace desmo::bench
