#pragma once

#include <optional>

#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// Largest drawn distance of a point from the line along which it slides, relative to the
/// mechanism: distance ≤ max_off_line · nominal::extent(). Files with six digits keep it.
inline constexpr double max_off_line = 1e-6;

/// Returns the drawn distance [unit of length] of a line's end from the axis through its start
/// along a vector. Returns 0 at rounding level. Returns 0, too, when a body that carries one of
/// them has its own frame: its drawing is an estimate. reach: reach_of(mechanism)
double drawn_off(const Mechanism& mechanism, const RigidBodies& rigid, double reach,
                 const Mechanism::Direction& line, int vector);

/// Returns a mechanism with new points for spatial sliding joints that are drawn off their line by
/// ≤ max_off_line, as a file's digits do. The line leads through the second body's point, as drawn.
/// The first body gets another point on it. Where the drawing does not tell the first body's
/// orientation, the second body gets that point. Where it tells neither, an offset has no
/// direction: the joint keeps its points, and assembly moves them onto the line. Returns nullopt
/// when no joint gets another point.
std::optional<Mechanism> with_lines_as_drawn(const Mechanism& mechanism, const RigidBodies& rigid);

}  // namespace desmo
