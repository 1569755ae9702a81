#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// Throws std::invalid_argument, naming the equation, where one between constants does not hold,
/// whatever their roundings: what rests on the ground is described twice, in different ways. Does
/// nothing for equations between drivers, and for tables.
/// - reach: largest absolute coordinate of a point [unit of length], nominally or in a body's own
///   frame. Each length may be off by max_rounding of it
void require_holds(const Model& model, const Constraint& constraint, double reach);

}  // namespace desmo
