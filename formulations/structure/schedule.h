#pragma once

#include <vector>

#include "formulations/structure/partition.h"

namespace desmo {

/// Reorders parts so that parts of one type follow each other, which keeps their code in the cache.
/// Constant parts stay first. The others are ordered by depth (longest chain of parts to be solved
/// before), then by type. Returns the end position of each range of parts that share type and
/// depth; parts of one range do not depend on each other.
std::vector<int> gather_types(const Model& model, std::vector<PartDefinition>& parts);

}  // namespace desmo
