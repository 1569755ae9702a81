// Code is generated, compiled and loaded at run time for a user's mechanism: desmo was built
// without kernels for its part types.
#pragma once

#include <chrono>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"
#include "formulations/runtime/generated_code.h"
#include "formulations/variants.h"

namespace desmo::load {

/// Adds to a table the kernels that a formulation needs and the table lacks, like generate_code().
/// Errors leave the table unchanged.
GenerationOutcome add_generated_code(KernelTable& table, const Variant& variant,
                                     const Settings& settings, const Model& model,
                                     const TimeGrid& grid, std::chrono::milliseconds compile_time);

}  // namespace desmo::load
