#pragma once

#include "formulations/model/model.h"

namespace desmo::properties {

/// Returns a model whose estimate is what its drawing means: the end of Newton's homotopy Φ(q) =
/// (1 − λ) Φ(drawing) with the drivers as drawn, in quadruple precision and short steps. Throws
/// std::runtime_error where the way is blocked.
Model with_assembled_drawing(Model model);

}  // namespace desmo::properties
