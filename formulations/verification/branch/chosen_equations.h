#pragma once

#include <memory>
#include <span>

#include "formulations/model/model.h"

namespace desmo {

/// Chooses anew which equations to keep in groups that have more equations than unknowns. Modelling
/// chooses them once. At single positions the kept ones may be dependent although all together have
/// full rank. Bennett's linkage is an example, when it is folded.
///
/// Returns the model with other equations kept; null if no group changes. Equations are rows of
/// the group's scaled Jacobian (Linearisation) at positions q (coordinates). QR of its transpose
/// with column pivoting ranks them, and the first ones are kept. A group changes only if its
/// smallest pivot grows more than 1.5-fold. Matrices are dense.
std::unique_ptr<const Model> with_chosen_equations(const Model& model, std::span<const double> q);

/// Returns whether a group that moves has left-out equations, other than those between constants.
bool has_other_equations(const Model& model);

}  // namespace desmo
