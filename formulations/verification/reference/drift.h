#pragma once

#include "formulations/formulation.h"
#include "formulations/verification/error.h"
#include "formulations/verification/reference/reference.h"

namespace desmo {

/// Errors at both ends of a long run, which show whether the error grows.
struct Drift {
  Summary summary;            ///< summary of the run; if not ok(), errors cover the solved part
  SolutionError first, last;  ///< errors over the first and the last `window` instants
  PerLevel<double> floor;     ///< floor of the reference (Reference::floor)
};

/// Runs a formulation over a grid and compares its first and its last `window` instants with a
/// reference in quadruple precision. In a grid of fewer than 2 × window instants the windows are
/// its halves. Errors are relative to the scales of both ends together. Times are i·Δt, never
/// accumulated. Angles are compared as they are, so that the rounding of a growing angle counts.
/// The reference follows the motion between the ends with a double-precision solution every 10 ms.
/// Throws std::runtime_error when there is no reference.
Drift measure_drift(Formulation& formulation, const TimeGrid& grid, int window);

}  // namespace desmo
