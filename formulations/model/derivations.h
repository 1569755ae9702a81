#pragma once

#include <utility>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Makes closures of constraints that cannot be derivations (clears Constraint::derives), where
/// - the constraint is not explicit in the entity: its derivatives by that are not (r, r, ±1),
/// - a row is left out,
/// - the entity is driven, fixed, of another group, or derived by an earlier constraint,
/// - the entity is derived from itself, by way of earlier ones.
void keep_derivations(Model& model);

/// A derived unknown of a part and the equation that is explicit in it.
struct Derivation {
  int row;     ///< equation of the part
  int column;  ///< unknown of the part
};

/// Returns the derivations of a part, in an order in which each reads only unknowns that are not
/// derived, or are derived before.
std::vector<Derivation> derivations(const Model& model, const PartDefinition& part);

/// Cuts off what no closure of a part needs: returns the part, and one after it with those
/// derivations, which outputs and later parts read. A part without unknowns is omitted.
std::vector<PartDefinition> split_outputs(const Model& model, const PartDefinition& part);

}  // namespace desmo
