#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cases/mechanism/motion.h"

namespace desmo::bench {

/// The run of this process that a record describes: when, by which command, under which load.
struct Run {
  std::string date;                             ///< time when it began (UTC, ISO 8601)
  std::string command;                          ///< program name and arguments
  std::vector<double> load_before, load_after;  ///< load_averages() at its begin and end
};

/// Returns `record` of results/record.schema.json: machine, build and settings of this program.
nlohmann::ordered_json environment_json(const Run& run, const TimeGrid& grid);

/// Returns the processor's name, with family, model and stepping where they are told.
std::string processor_name();

/// Returns the load averages over 1, 5 and 15 minutes; empty when unknown.
std::vector<double> load_averages();

/// Returns the current time, UTC, ISO 8601 to the second.
std::string utc_now();

/// Returns the name of the program, without its folder, and its arguments: Run::command.
std::string command_line(int argc, char** argv);

/// Returns the SHA-256 of the running program's file; "unknown" where it cannot be read.
std::string binary_digest();

/// Returns the names of the shared objects that the running program has loaded, sorted.
std::vector<std::string> shared_libraries();

}  // namespace desmo::bench
