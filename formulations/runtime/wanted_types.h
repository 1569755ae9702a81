#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/codegen/emit/library_source.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/model/model.h"
#include "formulations/runtime/own_kernels.h"
#include "formulations/variants.h"

namespace desmo::load {

/// Types of parts for which code is to be generated, and what they are for.
struct WantedTypes {
  std::vector<generate::SampledType> types;  ///< in all that they are called, names are numbers
  std::vector<TypeUse> uses;                 ///< of each
  int parts_too_large = 0;                   ///< left out: the work would be too much
};

/// Those of a formulation for which the table has not all of the code, sampled over the motion of
/// the mechanism on the grid. Throws Unavailable when the mechanism cannot be assembled, and what
/// make_partition throws.
WantedTypes wanted_types(const Variant& variant, generate::LibraryContents contents,
                         const Model& model, const TimeGrid& grid, const KernelTable& table);

}  // namespace desmo::load
