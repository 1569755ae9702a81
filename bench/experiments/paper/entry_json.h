#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/kit/candidate.h"

namespace desmo::paper {

/// Completes an entry of a record's list (results/record.schema.json), which names a candidate:
/// status, the message unless it is "ok", what was solved, where, with which results, how right it
/// is, and its times. A candidate without a time has less.
nlohmann::ordered_json with_measurement(nlohmann::ordered_json entry,
                                        const bench::Candidate& candidate);

}  // namespace desmo::paper
