#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/run_progress.h"
#include "bench/kit/candidate.h"

namespace desmo::paper {

/// Verifies and profiles all, and times what is verified by Google Benchmark, whose flags have been
/// read: in turn, in an order of its own, each as often as asked for or as is worth it. What is
/// wrong is said on standard error. first: the console has nothing yet.
/// Returns {"failed": whether anything did, "lists": what a record says (lists_of)}.
nlohmann::ordered_json measure(const std::vector<Candidate*>& all,
                               std::optional<int> asked_repetitions, bool first,
                               RunProgress& progress);

}  // namespace desmo::paper
