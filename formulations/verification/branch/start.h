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
  double share = 1;              ///< of the way of the blocked stage: last proven, from 0 to 1
  GroupId group = no_position;   ///< blocked: where the last proof failed, if it is known
  bool out_of_tests = false;     ///< blocked: the budget of the way ended, or is far too small;
                                 ///< nothing else is known
  std::vector<double> passed{};  ///< change points that the drivers passed, as shares of their way
  /// All coordinates: at the start where it is reached, else where the last proof was. Where
  /// nothing was proven, they are those of the drawing.
  std::vector<double> q;
  /// The change point on which the motion begins, unproven, and its smooth continuation; null: none
  /// is known. Where it is set, the stage is `drivers`.
  std::shared_ptr<PassedPoint> point{};
};

/// Finds the positions at a time [s] on the branch that the model's estimate, the drawing,
/// declares. Both parts of the way are followed in proven steps (BranchPath):
///
/// - the drawing may not solve the equations. With the drivers as drawn, Newton's homotopy Φ(q) =
///   (1 − λ) Φ(drawing) leads from there to what it means; all groups have one λ.
/// - then all drivers go straight from where they are drawn to their values at that time. Driven
///   angles make their whole turns; where these are more than a path has tests for, and a turn
///   leads back to where it begins, none of them.
///   Change points on the way are passed on the smooth continuation (pass_change_point()). The
///   motion may begin on one, if its drivers leave that smoothly.
///
/// A part that is blocked goes on by other equations of an overconstrained group, if these are
/// independent there (with_chosen_equations()); else no other way is sought than a change point's.
/// It is blocked at 0, too, where a driver has no finite value. Angles neither driven
/// nor coupled are those nearest to the drawing, whole turns apart. Positions are rounded: a
/// Refinement at that time proves them, and finds rates. Allocates; keep it out of timed code.
///
///   const FoundStart start = find_start(model, grid.time(0));
///   if (start.stage == FoundStart::Stage::reached) use(start.q);
FoundStart find_start(const Model& model, double time);

}  // namespace desmo
