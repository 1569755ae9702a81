#pragma once

#include <list>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "bench/kit/formulation_candidate.h"

namespace desmo::bench {

/// Verifies every formulation, then times them in turn, so that whatever slows the machine down for
/// a while meets them all. Names on standard error those that could not be timed. Returns whether
/// all were timed.
///
/// - repetitions: samples of each candidate, by a new formulation on a fresh heap; at most two
///   where a motion takes longer than a second
/// - list: first part of the names on standard error: "growth"
bool time_in_turn(std::list<FormulationCandidate>& candidates, int repetitions,
                  std::string_view list);

/// Returns the entry of a candidate that was timed in turn (`timed_size` of
/// results/record.schema.json), without `unknowns`.
nlohmann::ordered_json timed_entry(const FormulationCandidate& candidate);

}  // namespace desmo::bench
