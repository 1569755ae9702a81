#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "bench/kit/candidate.h"
#include "bench/kit/process/progress.h"

namespace desmo::paper {

/// Units of work that a candidate adds to the progress line: one for its verification, one for all
/// its repetitions.
inline constexpr double work_of_candidate = 2;

/// Arguments for Google Benchmark, and whether it prints its table.
struct Console {
  /// Repetitions of every candidate; nothing: 3 to 20, by the time of its analysis.
  std::optional<int> repetitions;
  bool has_table = true;  ///< a row for each benchmark, and why others are not run
  bool is_first = true;   ///< the machine was not yet described
};

/// Verifies and profiles all candidates, then lets Google Benchmark time the verified ones in its
/// own order. Its flags must have been read. Says on standard error what is wrong. Returns
/// {"failed": whether any candidate failed, "lists": what a results record
/// (results/record.schema.json) says of them, an object of arrays}.
nlohmann::ordered_json measure(const std::vector<bench::Candidate*>& all, const Console& console,
                               bench::Progress& progress);

}  // namespace desmo::paper
