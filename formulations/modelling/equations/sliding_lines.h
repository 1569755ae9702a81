#pragma once

#include <optional>

#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// Largest distance of a point of a sliding joint in space from its line, as drawn, over the extent
/// of the mechanism (nominal::extent): distance ≤ max_off_line · extent. Files of six digits keep
/// it.
inline constexpr double max_off_line = 1e-6;

/// Returns how far a line is drawn off the direction of a vector: 0 at rounding level, or where a
/// body that carries one of them has a frame, so that the drawing is an estimate. reach: that of
/// the mechanism
double drawn_off(const Mechanism& mechanism, const RigidBodies& rigid, double reach,
                 const Mechanism::Direction& line, int vector);

/// Returns a mechanism in which each sliding joint in space has its points on its line. Where
/// digits of a file draw them off it, the line leads through the point of the second body as it is
/// drawn; the first body carries another point on it. Where nothing tells how the first body is
/// turned about the line, the second body carries that point. Where nothing tells that of either,
/// an offset has no direction: the joint's own points stay, and come to lie on the line. nullopt:
/// no joint gets another point.
std::optional<Mechanism> with_lines_as_drawn(const Mechanism& mechanism, const RigidBodies& rigid);

}  // namespace desmo
