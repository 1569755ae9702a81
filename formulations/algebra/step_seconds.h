#pragma once

#include <span>
#include <vector>

#include "formulations/algebra/backend.h"

namespace desmo {

/// Wall-clock seconds of a step of a part with each of these backends: the least of several
/// samples, taken in turn. A step is two iterations of Newton's method from the mechanism's
/// estimate, and velocity and acceleration there: assembly, factorisation and solution of the
/// part's own matrices. Infinite where the part cannot be made or solved there.
///
/// It takes some milliseconds, tens where a step takes milliseconds itself; a backend that is found
/// to be slower than twice the fastest is not measured further.
std::vector<double> step_seconds(const PartContext& part, std::span<const Backend* const> backends);

}  // namespace desmo
