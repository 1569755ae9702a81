#pragma once

#include <string>
#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/modelling.h"

namespace desmo {

/// Those of spatial bodies all of whose points and vectors lie along one line, or that carry one
/// point alone: a joint that keeps a body from spinning gives it a vector across. In the order of
/// the bodies.
std::vector<IdleFreedom> find_idle_freedoms(const Mechanism& mechanism, const RigidBodies& rigid);

/// What a rigid body spins about that carries more than the centres of the two spherical joints by
/// which alone it hangs, so that its other points are not determined; otherwise empty.
std::string undetermined_spin(const Mechanism& mechanism, const RigidBodies& rigid, int body);

}  // namespace desmo
