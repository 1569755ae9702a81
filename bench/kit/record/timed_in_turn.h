#pragma once

#include <list>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "bench/kit/formulation_candidate.h"

namespace desmo::bench {

/// Verifies every formulation, then times them in turn, so that whatever slows the machine down for
/// a while meets them all. Names on standard error what is wrong, and returns whether nothing is.
///
/// - repetitions: samples of each, of a new formulation on a fresh heap; two of a motion that takes
///   longer than a second
/// - list: begins the names of what is wrong: "growth"
bool time_in_turn(std::list<FormulationCandidate>& candidates, int repetitions,
                  std::string_view list);

/// Returns what entries of a record have in common that were timed in turn (`timed_size` of
/// results/record.schema.json), but for `unknowns`.
nlohmann::ordered_json timed_entry(const FormulationCandidate& candidate);

}  // namespace desmo::bench
