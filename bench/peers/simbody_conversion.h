#pragma once

#include "bench/peers/simbody_solver.h"
#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"

namespace desmo::simbody {

/// Returns a case as a tree of Simbody's bodies that constraints close. The tree has as few
/// mobilities and loop equations as there can be: Simbody's time grows with their third power.
/// - four_bar: crank and rockers turn on the ground; a coupler is a rod, which is one equation.
/// - truck_suspension: the upper arm turns on the ground, the axle hangs on it, dampers and levers
///   of the stabiliser on the axle; lower rods and links are rods. A damper, two bodies that slide
///   along each other, is one body whose line passes through a point of the chassis.
/// - A driven angle is a prescribed pin; a driven height is a prescribed slider, and a plane that
///   moves with it.
///
/// The tree follows (Tree::followed) all points and vectors of its bodies that move. Relative
/// coordinates, and the vectors of rods, are not found.
/// - scene: gives the nominal position and the drivers' motions; must outlive the tree
/// - model: model of the mechanism, which gives the indices of coordinates
///
/// Throws std::invalid_argument, naming the mechanism, unless it is one of the two.
Tree convert(const Scene& scene, const Model& model);

}  // namespace desmo::simbody
