#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// Returns whether the equations left out of a constraint hold wherever some other constraint of
/// its group does. The length of a link, for example, follows from the definition of its angle.
/// Such equations need not be checked on any branch. Decided numerically, at random positions.
bool is_implied(const Model& model, const Constraint& constraint);

}  // namespace desmo
