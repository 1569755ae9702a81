#pragma once

#include <array>

#include "formulations/modelling/measures/measures.h"

namespace desmo {

/// Returns the rule of a ratio of two coordinates' rates (Measures).
/// - of: positions in q of the coordinate whose rate is divided, and of the one that divides it
Measures::Rule rate_ratio(const Model& model, const std::array<int, 2>& of,
                          Measures::DrivenBy driven_by);

}  // namespace desmo
