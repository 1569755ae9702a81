#pragma once

#include <vector>

#include "formulations/structure/partition.h"

namespace desmo {

/// Puts parts of one type next to each other, as far as each stays behind those it needs: their
/// code then is still at hand. Constant parts stay first. Parts of equal rank keep their order.
/// Returns where runs end: positions behind the last of parts of one type that do not need each
/// other.
std::vector<int> gather_types(const Model& model, std::vector<PartDefinition>& parts);

}  // namespace desmo
