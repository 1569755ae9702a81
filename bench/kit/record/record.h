#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/kit/record/environment.h"
#include "bench/kit/verification.h"
#include "cases/io/new_files.h"
#include "cases/mechanism/motion.h"

namespace desmo::bench {

class Candidate;

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
  /// grid: the grid in the record's settings; where there are several, the usual one.
  /// lists: an object of arrays; empty ones are left out.
  /// windows: number of timing windows into which a motion was cut; nothing: it was not cut.
  void write(const TimeGrid& grid, const nlohmann::ordered_json& lists,
             std::optional<int> windows = {});

 private:
  OutputFile file_;
  Run run_;
  const std::string experiment_;
};

/// Returns the head of a record without lists: environment and settings, with the current time and
/// load.
nlohmann::ordered_json record_head(const std::string& command, const TimeGrid& grid);

/// Returns an object with the value of each level by the level's name.
nlohmann::ordered_json per_level_json(const PerLevel<double>& values);

/// Returns `verification` of a candidate: its errors up to a level, above which nothing was
/// compared.
nlohmann::ordered_json errors_json(const Differences& errors, Level level = Level::acceleration);

/// Returns samples of CPU time [s], rounded to five digits: samples are many, and no machine
/// repeats more digits.
nlohmann::ordered_json rounded_time_json(const std::vector<double>& seconds);

/// Completes an entry of a record's list (results/record.schema.json), which names a candidate.
/// Adds status, the message unless it is "ok", machine, digests of model and results, errors and
/// times. Leaves out errors and times of a candidate that was not timed, and all but the first two
/// of one that was not run.
nlohmann::ordered_json with_measurement(nlohmann::ordered_json entry, const Candidate& candidate);

/// Returns a value, not −∞, rounded to `digits` significant digits. Returns 1e100 for NaN and all
/// values above 1e100, since JSON has no infinite numbers.
double rounded(double value, int digits);

}  // namespace desmo::bench
