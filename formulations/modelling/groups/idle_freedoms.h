#pragma once

#include <string>
#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/modelling.h"

namespace desmo {

/// Returns the idle freedoms of spatial bodies, in the order of the bodies. A body has one when all
/// its points and vectors lie along one line, or when it carries a single point. (A joint that
/// prevents the spin gives the body a vector across the line.)
std::vector<IdleFreedom> find_idle_freedoms(const Mechanism& mechanism, const RigidBodies& rigid);

/// Returns the axis about which an under-constrained rigid body can spin, if its only joints are
/// spherical and have two centres; otherwise an empty string.
std::string undetermined_spin(const Mechanism& mechanism, const RigidBodies& rigid, int body);

}  // namespace desmo
