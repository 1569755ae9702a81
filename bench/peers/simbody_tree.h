#pragma once

// A tree of Simbody's bodies, made from the plain data that describe it (Tree). Only sources that
// include Simbody may include this (see simbody_solver.h).

#include <SimTKsimbody.h>

#include <vector>

#include "bench/peers/simbody_solver.h"

namespace desmo::simbody {

struct BuiltTree {
  explicit BuiltTree(const Tree& tree);

  /// Returns a body; the ground for -1.
  SimTK::MobilizedBody& body(int i) {
    return i < 0 ? static_cast<SimTK::MobilizedBody&>(matter.updGround()) : bodies[i];
  }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  std::vector<SimTK::MobilizedBody> bodies;  ///< in the order of Tree::bodies
};

}  // namespace desmo::simbody
