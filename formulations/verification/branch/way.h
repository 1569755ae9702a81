#pragma once

#include "formulations/verification/branch/start.h"

namespace desmo {

/// Follows a way from 0 to 1, the time of the model's motions, in proven steps. What is regular by
/// other equations of an overconstrained group is no change point, so these are tried first.
/// Returns whether it is proven to its end.
/// - may_pass: change points are passed, and noted in found.passed
/// - found: the way begins at its positions, which are overwritten by the last proven ones; so are
///   the share, the group and whether tests ran out
bool follow_way(const Model& model, bool may_pass, FoundStart& found);

}  // namespace desmo
