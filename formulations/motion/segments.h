#pragma once

#include <optional>
#include <span>

#include "cases/mechanism/motion.h"
#include "formulations/base/observer.h"
#include "formulations/base/state.h"
#include "formulations/base/summary.h"
#include "formulations/model/model.h"

namespace desmo {

/// A solver of the segments of a motion that is known in advance. Each is reached by continuation
/// from the first position of the motion, and solved on its own. Whether all lie on one branch is
/// checked where a segment ends and the next has begun (segments_meet).
class SegmentExecutor {
 public:
  virtual ~SegmentExecutor() = default;
  /// Hands every instant of the grid to an observer that lends memory and takes any order. state:
  /// the first instant, assembled; overwritten by the last, unless the observer stops the run.
  /// Returns nothing when the motion has to be solved step by step after all; the state and what
  /// the observer was given are then void.
  virtual std::optional<Summary> run(const TimeGrid& grid, const Request& request, State& state,
                                     Observer& observer) = 0;
  /// Leaves out levels, as Formulation::solve_only() does.
  virtual void solve_only(std::span<const Level>) {}
};

/// Returns whether a segment ended where the next had begun. ended, begun: positions of one instant
/// in coordinate order. On one branch, converged positions differ by far less than is allowed; on
/// different branches they usually differ by far more.
bool segments_meet(const Model& model, std::span<const double> ended,
                   std::span<const double> begun);

}  // namespace desmo
