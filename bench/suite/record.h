#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/suite/timed.h"

namespace desmo::suite {

/// What the record holds beside what was timed.
struct Run {
  std::string date;     ///< UTC, when it began
  std::string command;  ///< program name and arguments
  std::vector<double> load_before, load_after;
};

/// Name of the program, without its folder, and its arguments: Run::command.
std::string command_line(int argc, char** argv);

/// The results record (results/record.schema.json) of these, at least one; all have the same time
/// grid.
std::string record_text(const Run& run, const std::vector<Timed*>& timed);

/// A record without cells. grid: the usual one, for the settings; lists: an object of arrays, what
/// it holds instead.
std::string record_text(const Run& run, const TimeGrid& grid, const nlohmann::ordered_json& lists);

}  // namespace desmo::suite
