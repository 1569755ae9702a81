#pragma once

#include <string>
#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// A freedom of a body that moves none of its points and vectors: of a coupler between two
/// spherical joints, the spin about their line. Nothing depends on it and no coordinate models it.
struct IdleFreedom {
  std::string body;   ///< the first of those that are rigidly joined
  std::string about;  ///< what it is free to spin about: "the line of 'A' and 'B'"

  bool operator==(const IdleFreedom&) const = default;
};

/// Those of spatial bodies all of whose points and vectors lie along one line, or that carry one
/// point alone: a joint that keeps a body from spinning gives it a vector across. In the order of
/// the bodies.
std::vector<IdleFreedom> find_idle_freedoms(const Mechanism& mechanism, const RigidBodies& rigid);

/// What a rigid body spins about that carries more than the centres of the two spherical joints by
/// which alone it hangs, so that its other points are not determined; otherwise empty.
std::string undetermined_spin(const Mechanism& mechanism, const RigidBodies& rigid, int body);

}  // namespace desmo
