#pragma once

#include <utility>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Makes closures of constraints that cannot be derivations: sets Constraint::derives to
/// no_position where
/// - the constraint is not explicit in the entity: its derivatives by the entity are not a diagonal
///   matrix with entries ±1,
/// - a row is left out,
/// - the entity is driven, fixed, of another group, or derived by an earlier constraint,
/// - the entity would be derived from itself, by way of earlier derivations.
void keep_derivations(Model& model);

/// A derived unknown of a part and the equation that is explicit in it.
struct Derivation {
  int row;     ///< position among the part's equations
  int column;  ///< position among the part's unknowns
};

/// Returns the derivations of a part, in an order in which each reads only unknowns that are not
/// derived, or are derived before.
std::vector<Derivation> derivations(const Model& model, const PartDefinition& part);

/// Cuts a part in two: the closures with all derivations that they need, then all other
/// derivations. Only outputs and later parts read the unknowns of the second. A part without
/// unknowns is omitted.
std::vector<PartDefinition> split_outputs(const Model& model, const PartDefinition& part);

}  // namespace desmo
