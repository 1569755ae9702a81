#pragma once

#include <vector>

#include "cases/numbers/derived.h"
#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// Returns the cᵢ with offset = Σ cᵢ directionᵢ for the basis of a body in space, or nearest to it.
/// Factors at rounding level are zero. magnitude: of the positions whose difference is the offset.
std::vector<Derived> coefficients_in_space(const Mechanism& mechanism, const RigidBody& body,
                                           const Mechanism::Direction& offset, double magnitude);

}  // namespace desmo
