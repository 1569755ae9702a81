#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/experiments/accuracy/series.h"
#include "bench/experiments/accuracy/trial.h"
#include "bench/kit/record/record.h"

namespace desmo::accuracy {

/// What is known of a problem beside its trials: `floors` of the record.
nlohmann::ordered_json floor_json(const Series& series, const Problem& problem);

/// A point of the work–precision diagram: `precision` of the record.
nlohmann::ordered_json point_json(const Series& series, const Trial& trial);

}  // namespace desmo::accuracy
