#pragma once

#include <vector>

#include "formulations/equations/kernel_table.h"
#include "formulations/structure/defined_part.h"

namespace desmo {

/// Parts in explicit order on wide registers, up to so many at once: copies of one and the same
/// piece of the mechanism, which need nothing of each other, each in a lane of its own; or, where
/// fewer calls of kernels do it so, the parts of a type that do not need each other. run_ends:
/// behind the last of such parts (see gather_types). Parts without code for lanes stay alone.
std::vector<DefinedPart> on_lanes(const Model& model, std::vector<DefinedPart> parts,
                                  const std::vector<int>& run_ends, const Settings& settings,
                                  const KernelTable& table);

}  // namespace desmo
