#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/regression/rounds.h"

namespace desmo::regression {

/// Counts, for each candidate on each side, the instructions of a fixed number of steps with a
/// fixed number of iterations. Returns them as `work` of a results file. Throws std::runtime_error,
/// naming the candidate, when they cannot be counted.
nlohmann::ordered_json counted_work(const std::vector<std::string>& names,
                                    const std::vector<Side>& sides);

/// A commit whose instructions are counted.
struct Commit {
  std::string name;     ///< its hash, shortened
  std::string date;     ///< time of the commit (UTC, ISO 8601), by which points are sorted
  std::string message;  ///< first line of its message
};

/// Counts the instructions of candidates in a commit's programs, and adds a point to a history,
/// which may be empty. A candidate that the programs do not have is null in the point. One that the
/// history does not have yet becomes null in all its other points. Throws std::runtime_error when
/// something cannot be counted.
void add_point(nlohmann::ordered_json& history, const Side& programs, const Commit& commit,
               const std::vector<std::string>& names);

/// Returns the JSON text of a history, with one line for each point.
std::string text_of(const nlohmann::ordered_json& history);

}  // namespace desmo::regression
