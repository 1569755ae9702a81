#pragma once

#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/codegen/emit/library_source.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/model/model.h"
#include "formulations/runtime/generated_code.h"
#include "formulations/variants.h"

namespace desmo::load {

/// Returns the part types of a formulation for which the table lacks code, or has code that refuses
/// steps of the motion. They have samples of the motion over `grid` and neutral names (see
/// without_names). Leaves out parts that are too large. Throws Unavailable when the model cannot be
/// assembled, and what make_partition throws. told: receives the use of each type, and the number
/// of parts that are too large.
std::vector<generate::SampledType> wanted_types(const Variant& variant,
                                                generate::LibraryContents contents,
                                                const Model& model, const TimeGrid& grid,
                                                const KernelTable& table, GenerationOutcome& told);

}  // namespace desmo::load
