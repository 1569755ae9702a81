#pragma once

#include <string_view>
#include <vector>

#include "formulations/modelling/coordinates/coordinates.h"

namespace desmo {

/// Ends of Constraint::name, after the name of the joint, of equations that keep a point's
/// distance: from a line in the plane, and from a plane in space.
inline constexpr std::string_view offset_equation = ": offset",
                                  plane_distance_equation = ": distance from the plane";

/// Makes a model with all constraint equations that its mechanism gives rise to, in group order;
/// some may depend on others. It has coordinates (see make_coordinates) and these candidate
/// equations (García de Jalón & Bayo, 1994):
/// - bodies: constant products of the basis, linear relations for other points and vectors;
/// - joints: an angle between vectors or an offset from a line; shared points and vectors need no
///   equation;
/// - relative coordinates: their definitions, which also define the joints along which they slide
///   where these are drawn on their line (with_lines_as_drawn());
/// - couplings: an equation each, linear unless by a table;
/// - ground vectors that are coordinates: linear equations that hold them.
/// An equation belongs to the last group that solves for one of its coordinates. Unless coordinates
/// are natural, an equation that is explicit in an entity derives it. An example is a point in
/// terms of its body's basis. motions: one per driven coordinate, in order. Throws
/// std::invalid_argument, naming the coordinate, joint or coupling, when it cannot be modelled.
Model make_candidate_equations(const Mechanism& mechanism, const RigidBodies& rigid,
                               const Structure& structure, const std::vector<Motion>& motions,
                               Modelling modelling = Modelling::natural);

}  // namespace desmo
