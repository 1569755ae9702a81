#pragma once

#include <vector>

#include "formulations/model/model.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// Loops that lock at a dead point, one or several at once.
struct LockedLoops {
  std::vector<GroupId> groups;   ///< groups of the singular blocks, in solution order
  std::vector<EntityId> moving;  ///< what their null vectors move while all drivers rest
  /// About (arc point – dead point) / (arc before – dead point), which is < 1/2. 0: not measured.
  double left = 0;
};

/// Finds the loops that lock right after a point of a curve. Towards a lock a singular value of its
/// block's Φ_φ falls like the distance. It counts if it more than halves from `before` to `point`.
/// Rows are divided by their sums, columns multiplied by characteristic lengths. Entities move if
/// their components of null vectors exceed locking_arc × the largest. The algebra is dense in each
/// block.
/// - before: a locking_arc before the point
/// - point: next to the dead point
LockedLoops find_locked_loops(const Model& model, const SolutionCurve& curve,
                              const SolutionCurve::Point& before,
                              const SolutionCurve::Point& point);

/// Finds the first block that moves along the tangent at a dead point, where the driver rests, and
/// what it moves.
LockedLoops first_locked_loop(const Model& model, const SolutionCurve& curve,
                              const SolutionCurve::Point& point);

}  // namespace desmo
