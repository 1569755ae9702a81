#pragma once

#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Returns whether a block may have no solution: it determines more than scalars that are measured,
/// by equations that are not linear. Of a single body, such as a crank that is turned, those count
/// as linear that are so once what it follows is known.
/// owner: entity of each coordinate
bool may_lock(const Model& model, const PartDefinition& block, const std::vector<EntityId>& owner);

}  // namespace desmo
