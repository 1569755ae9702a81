#pragma once

#include <memory>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

struct PassedPoint;

/// Positions to which the drawing leads.
struct FoundStart {
  enum class Stage {
    reached,  ///< the positions are proven to be on the branch of the drawing
    drawing,  ///< the drawing cannot be led to positions that solve the equations
    drivers,  ///< drivers cannot be led from where they are drawn to where they begin
  };
  Stage stage = Stage::reached;
  double share = 1;              ///< blocked: share of the stage's way that is proven, from 0 to 1
  GroupId group = no_position;   ///< blocked: group of the last failed proof, if it is known
  bool out_of_tests = false;     ///< blocked: tests ran out, or are far too few for the way; no
                                 ///< other obstacle is known
  std::vector<double> passed{};  ///< change points that the drivers passed, as shares of their way
  /// Positions (coordinates): of the start if it is reached, else the last proven ones; those of
  /// the drawing if none are.
  std::vector<double> q;
  /// The change point on which the motion begins, with its smooth continuation; null: none is
  /// known. If it is set, the stage is `drivers`: positions on the point are not proven.
  std::shared_ptr<PassedPoint> point{};
};

/// Finds the positions at a time [s] on the branch that the model's estimate, the drawing,
/// declares. Both parts of the way are followed in proven steps (BranchPath):
///
/// - First, if the drawing does not solve the equations, Newton's homotopy leads to a solution:
///   Φ(q) = (1 − λ) Φ(drawing), λ from 0 to 1, with the drivers as drawn. All groups have one λ.
/// - Then all drivers go straight from where they are drawn to their values at that time. Driven
///   angles make their whole turns. If a path has too few tests for that, and turns lead back to
///   where they begin, all whole turns are left out.
///   Change points on the way are passed on the smooth continuation (pass_change_point()). The
///   motion may begin on one, if its drivers leave that smoothly.
///
/// Where a part is blocked, other equations of overconstrained groups that are independent there
/// are tried first (with_chosen_equations()). No other way is sought. A driver without a finite
/// value blocks the way at 0. Angles that are neither driven nor coupled are taken within half a
/// turn of the drawing. Positions are rounded: a Refinement at that time proves them, and finds
/// rates. Allocates; keep it out of timed code.
///
///   const FoundStart start = find_start(model, grid.time(0));
///   if (start.stage == FoundStart::Stage::reached) use(start.q);
FoundStart find_start(const Model& model, double time);

}  // namespace desmo
