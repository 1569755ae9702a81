#pragma once

#include <vector>

#include "formulations/equations/kernel_table.h"
#include "formulations/structure/defined_part.h"

namespace desmo {

/// Joins parts in explicit order to batches of up to settings.lanes: equal subsystems that need
/// nothing of each other, or, where that takes fewer calls of kernels, parts of one type that do
/// not need each other. type_ends: the end of each range of such parts (see gather_types). Parts
/// without code for lanes stay alone.
std::vector<DefinedPart> make_batches(const Model& model, std::vector<DefinedPart> parts,
                                      const std::vector<int>& type_ends, const Settings& settings,
                                      const KernelTable& table);

}  // namespace desmo
