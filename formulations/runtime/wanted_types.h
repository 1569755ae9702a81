#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/codegen/emit/library_source.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/model/model.h"
#include "formulations/runtime/generated_code.h"
#include "formulations/variants.h"

namespace desmo::load {

/// The part types for which code is to be generated.
struct WantedTypes {
  std::vector<generate::SampledType> types;  ///< with neutral names (see without_names)
  std::vector<TypeUse> uses;                 ///< use of each type
  int parts_too_large = 0;                   ///< parts omitted because they are too large
};

/// Returns the part types of a formulation for which the table lacks code, or has code that refuses
/// steps of the motion over `grid`, with samples of that motion. Throws Unavailable when the model
/// cannot be assembled, and what make_partition throws.
WantedTypes wanted_types(const Variant& variant, generate::LibraryContents contents,
                         const Model& model, const TimeGrid& grid, const KernelTable& table);

}  // namespace desmo::load
