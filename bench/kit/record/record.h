#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/kit/candidate.h"

namespace desmo::bench {

/// What the record holds beside what was timed.
struct Run {
  std::string date;     ///< UTC, when it began
  std::string command;  ///< program name and arguments
  std::vector<double> load_before, load_after;
};

/// Name of the program, without its folder, and its arguments: Run::command.
std::string command_line(int argc, char** argv);

/// What a results record (results/record.schema.json) says of these, as an object of arrays.
nlohmann::ordered_json lists_of(const std::vector<Candidate*>& timed);

/// Returns the text of a record.
///
/// grid: for the settings, the usual one where there are several.
/// lists: an object of arrays, whose names say to which experiment each belongs.
/// windows: timing windows into which motions were cut, where they were.
std::string record_text(const Run& run, const TimeGrid& grid, const nlohmann::ordered_json& lists,
                        std::optional<int> windows = {});

}  // namespace desmo::bench
