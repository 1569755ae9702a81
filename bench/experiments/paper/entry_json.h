#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/kit/candidate.h"

namespace desmo::paper {

/// Completes an entry of a record's list (results/record.schema.json), which names a candidate.
/// Adds status, the message unless it is "ok", machine, digests of model and results, errors and
/// times. Leaves out errors and times of a candidate that was not timed, and all but the first two
/// of one that was not run.
nlohmann::ordered_json with_measurement(nlohmann::ordered_json entry,
                                        const bench::Candidate& candidate);

}  // namespace desmo::paper
