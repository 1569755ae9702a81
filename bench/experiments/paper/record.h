#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bench/kit/candidate.h"

namespace desmo::paper {

/// Returns what a results record (results/record.schema.json) says of candidates, as an object of
/// arrays.
nlohmann::ordered_json lists_of(const std::vector<bench::Candidate*>& candidates);

}  // namespace desmo::paper
