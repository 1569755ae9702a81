#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// Returns whether an equation between constants holds, but for their roundings. Where it does not,
/// what rests on the ground is described twice, in different ways.
/// - reach: largest absolute coordinate of a point [unit of length], nominally or in a body's own
///   frame. Each length may be off by max_rounding of it
bool holds(const Model& model, const Constraint& constraint, double reach);

}  // namespace desmo
