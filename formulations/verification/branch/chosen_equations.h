#pragma once

#include <memory>
#include <span>

#include "formulations/model/model.h"

namespace desmo {

/// Chooses anew which equations groups keep that have more than they need. Modelling chooses them
/// once, and they may become dependent at single positions where all equations are not: Bennett's
/// linkage folded.
///
/// Returns the model with equations that are independent of each other at positions q
/// (coordinates), those that differ most first (QR with pivoting of each group's scaled Jacobian).
/// A group keeps its equations where others are hardly better. Null: all do, or have no others.
/// Dense in each group that has.
std::unique_ptr<const Model> with_chosen_equations(const Model& model, std::span<const double> q);

/// Returns whether a group that moves has equations that were left out, not counting those between
/// constants.
bool has_other_equations(const Model& model);

}  // namespace desmo
