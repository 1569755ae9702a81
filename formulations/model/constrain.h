#pragma once

#include <array>
#include <string>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/model/model.h"

namespace desmo {

/// Adds a constraint of a kind to a group: Model::add, with numbers of operands and constants that
/// the compiler checks.
///
///   constrain<Length<2>>(model, group, "rod", {a, b}, {length * length});
template <class Kind>
void constrain(Model& model, GroupId group, std::string name,
               const std::array<EntityId, Kind::operand_sizes.size()>& operands,
               const std::array<double, Kind::constants>& constants = {}) {
  model.add({std::move(name),
             kind_index<Kind>(),
             {operands.begin(), operands.end()},
             {constants.begin(), constants.end()},
             group,
             0});
}

}  // namespace desmo
