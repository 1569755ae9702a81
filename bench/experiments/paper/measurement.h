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

/// Verifies and profiles all, and times what is verified by Google Benchmark, whose flags have been
/// read: in turn, in an order of its own, each as often as asked for or as is worth it. Says on
/// standard error what is wrong. first: the console has nothing yet.
/// Returns {"failed": whether anything did, "lists": what a record says (lists_of)}.
nlohmann::ordered_json measure(const std::vector<bench::Candidate*>& all,
                               std::optional<int> asked_repetitions, bool first,
                               bench::Progress& progress);

/// Returns what a results record (results/record.schema.json) says of candidates, as an object of
/// arrays.
nlohmann::ordered_json lists_of(const std::vector<bench::Candidate*>& candidates);

}  // namespace desmo::paper
