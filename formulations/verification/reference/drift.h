#pragma once

#include "formulations/formulation.h"
#include "formulations/verification/error.h"
#include "formulations/verification/reference/reference.h"

namespace desmo {

/// Errors at the ends of a long run: does the error grow?
struct Drift {
  Summary summary;    ///< of the run; when it is not ok() the errors are those of what was solved
  Error first, last;  ///< over the first and the last `window` instants
  PerLevel<double> floor;  ///< of the reference
};

/// Runs a formulation over a grid and compares its first and its last `window` instants (fewer when
/// the grid has fewer than twice as many) with a reference in quadruple precision, relative to the
/// scales of both ends together. Instants are those of the grid, i·Δt, never accumulated; angles
/// that turn on and on are compared as they are, so that the rounding of their growing value
/// counts. Following the motion to the last window takes the reference a double-precision solution
/// each 10 ms. Throws std::runtime_error when there is no reference.
Drift measure_drift(Formulation& formulation, const TimeGrid& grid, int window);

}  // namespace desmo
