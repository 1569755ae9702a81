#pragma once

#include "bench/peers/simbody_solver.h"
#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"

namespace desmo::simbody {

/// Returns a mechanism as a tree of Simbody's bodies that constraints close. The tree has as few
/// mobilities and loop equations as these rules allow: Simbody's time grows with their third power.
/// - A body hangs on the tree by the joint with the fewest mobilities, nearest to the ground.
/// - A rod is one equation: a body with two points, and nothing but joints there.
/// - A strut is one body whose line passes through a point: two bodies that slide along each other.
/// - A driven angle is a prescribed pin; a driven height is a prescribed slider, and a plane that
///   moves with it.
///
/// The tree asks for all points and vectors of its bodies that move. Relative coordinates, and the
/// vectors of rods, are not found.
/// - scene: its mechanism in the nominal position, and its motions; it must outlive the tree
/// - model: the mechanism's, which says where coordinates stand
///
/// Throws std::invalid_argument where other loops must be closed or, naming it, a joint or a driven
/// coordinate has no counterpart here.
Tree convert(const Scene& scene, const Model& model);

}  // namespace desmo::simbody
