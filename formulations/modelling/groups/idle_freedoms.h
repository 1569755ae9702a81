#pragma once

#include <string>
#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// An idle freedom: a motion of a body that moves none of its points and vectors. An example is the
/// spin of a coupler about the line of its two spherical joints. No coordinate models it.
struct IdleFreedom {
  std::string body;   ///< first body of the rigid body
  std::string about;  ///< centre or axis of the spin: "the line of 'A' and 'B'"

  bool operator==(const IdleFreedom&) const = default;
};

/// Returns the idle freedoms of spatial bodies, in the order of the bodies. A body has one when all
/// its points and vectors lie along one line, or when it carries a single point. (A joint that
/// prevents the spin gives the body a vector across the line.)
std::vector<IdleFreedom> find_idle_freedoms(const Mechanism& mechanism, const RigidBodies& rigid);

/// Returns the axis about which an under-constrained rigid body can spin, if its only joints are
/// spherical and have two centres; otherwise an empty string.
std::string undetermined_spin(const Mechanism& mechanism, const RigidBodies& rigid, int body);

}  // namespace desmo
