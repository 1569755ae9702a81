#pragma once

#include "formulations/verification/branch/start.h"

namespace desmo {

/// Follows the motions of a model from time 0 to 1 in proven steps. Where it is stuck, tries other
/// equations of overconstrained groups first: a position that is regular with these is no change
/// point. Returns whether the way is proven to its end.
/// - may_pass: change points are passed, and added to found.passed
/// - found: in, the positions at which the way begins; out, the last proven ones, the share, the
///   group, and whether tests ran out
bool follow_continuation(const Model& model, bool may_pass, FoundStart& found);

}  // namespace desmo
