#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/experiments/size/candidate.h"
#include "bench/experiments/size/series.h"

namespace desmo::size {

/// Returns a contender's entry in `growth` or `break_even` of the record
/// (results/record.schema.json).
nlohmann::ordered_json entry_json(const Series& series, const Problem& problem,
                                  const Contender& contender);

}  // namespace desmo::size
