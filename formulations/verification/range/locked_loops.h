#pragma once

#include <vector>

#include "formulations/model/model.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// Loops that lock at a dead point, one or several at once.
struct LockedLoops {
  std::vector<GroupId> groups;   ///< those of singular blocks, in solution order
  std::vector<EntityId> moving;  ///< what their null vectors move, while all drivers rest
  double left = 0;  ///< what is left of the arc up to the dead point, over all of it; below 1/2
};

/// Names the loops that lock at the end of the last arc of a curve: towards a lock a singular value
/// of its block's Φ_φ falls like the distance, so that it more than halves there. Rows are divided
/// by their sums, columns multiplied by characteristic lengths. Components of null vectors are
/// known to a locking_arc. Dense in each block.
/// - before: a locking_arc from the point
/// - point: next to the dead point
LockedLoops find_locked_loops(const Model& model, const SolutionCurve& curve,
                              const SolutionCurve::Point& before,
                              const SolutionCurve::Point& point);

/// Names the first block that moves along the tangent at a dead point, where the driver rests.
LockedLoops first_locked_loop(const Model& model, const SolutionCurve& curve,
                              const SolutionCurve::Point& point);

}  // namespace desmo
