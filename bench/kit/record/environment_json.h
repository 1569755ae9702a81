#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/kit/record/record.h"
#include "bench/kit/record/schema_version.h"
#include "bench/kit/verification.h"
#include "cases/mechanism/motion.h"

namespace desmo::bench {

/// `record` of results/record.schema.json: machine, build and settings of this program.
nlohmann::ordered_json environment_json(const Run& run, const TimeGrid& grid);

/// `verification` of a cell.
nlohmann::ordered_json errors_json(const Errors& errors);

}  // namespace desmo::bench
