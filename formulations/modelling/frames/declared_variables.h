#pragma once

#include "formulations/modelling/coordinates/placement.h"
#include "formulations/modelling/frames/axes.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo {

/// Finds which coordinates of a mechanism measure what a tree joint varies: they are its variables.
/// All arguments outlive this.
class DeclaredVariables {
 public:
  DeclaredVariables(const FramedMechanism& framed, const AxisMaker& axes,
                    const Structure& structure, const Placement& placement)
      : framed_(framed), axes_(axes), structure_(structure), placement_(placement) {}

  /// Return the declared travel along the sliding joint by which a rigid body hangs, or the
  /// declared angle about its axis; none: there is none. axis: of the joint; none in the plane.
  int travel(int body, const Mechanism::Joint& joint) const;
  int angle(int body, int axis) const;

 private:
  bool is_found_with(int body, const Mechanism::Coordinate& coordinate) const;
  bool turns(const Mechanism::Coordinate& coordinate, int parent, int body, int axis) const;

  const FramedMechanism& framed_;
  const AxisMaker& axes_;
  const Structure& structure_;
  const Placement& placement_;
};

}  // namespace desmo
