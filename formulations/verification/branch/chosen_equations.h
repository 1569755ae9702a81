#pragma once

#include <memory>
#include <span>

#include "formulations/model/model.h"

namespace desmo {

/// Chooses anew which equations to keep in groups that have more equations than unknowns. Modelling
/// chooses them once. At single positions the kept ones may be dependent although all together have
/// full rank. Bennett's linkage is an example, when it is folded.
///
/// Returns the model with the equations that QR with column pivoting picks first, from each group's
/// scaled Jacobian at positions q (coordinates). A group changes its equations only if the smallest
/// pivot grows more than 1.5-fold. Returns null if no group changes. The Jacobian of each such
/// group is dense.
std::unique_ptr<const Model> with_chosen_equations(const Model& model, std::span<const double> q);

/// Returns whether a group that moves has left-out equations, other than those between constants.
bool has_other_equations(const Model& model);

}  // namespace desmo
