#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/experiments/extremes/table.h"

namespace desmo::extremes {

/// Elements of `extreme_rows` and of `extremes` in the record (results/record.schema.json).
nlohmann::ordered_json row_json(const Extreme& row);
nlohmann::ordered_json result_json(const Result& result);

}  // namespace desmo::extremes
