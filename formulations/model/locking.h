#pragma once

#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/part_system.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Returns whether a block may have no solution: a point or vector is among its unknowns, and an
/// equation is not linear. In a group of one body, such as a crank, equations count as linear that
/// are so in the block's unknowns.
/// - owner: entity of each coordinate
/// - drawn: estimate and fixed values, changed while this is found out
bool may_lock(const Model& model, const PartDefinition& block, const std::vector<EntityId>& owner,
              ScalarState<double>& drawn);

}  // namespace desmo
