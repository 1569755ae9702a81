#pragma once

#include <optional>

#include "formulations/modelling/frames/frames.h"

namespace desmo {

/// Gives bodies in space that lie nearly in a plane its normal as a third direction of their bases:
/// where no direction leads farther than 6° out of the plane of two others, but some point or
/// vector lies off it by more than rounding. A third direction of the body's own would make
/// equations that are nearly dependent, and without one the body would be flat. Returns the
/// mechanism with these vectors, and its rigid bodies (its other members mean nothing); nothing
/// where it needs none.
std::optional<FramedMechanism> with_plane_normals(const Mechanism& mechanism,
                                                  const RigidBodies& rigid);

}  // namespace desmo
