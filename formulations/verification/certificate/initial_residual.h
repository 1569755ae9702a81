#pragma once

#include <span>
#include <vector>

namespace desmo {

/// Φ₀ of each constraint in Newton's homotopy Φ(q, t) = (1 − t) Φ₀: by constraints, then by rows.
/// Empty: the equations are Φ(q, t) = 0.
using InitialResidual = std::span<const std::vector<double>>;

}  // namespace desmo
