#pragma once

#include <memory>

#include "formulations/base/part.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// A part of a formulation: what it solves, and the solver.
struct DefinedPart {
  PartDefinition definition;
  std::unique_ptr<Part> solver;
  /// Says whether the part is what the formulation's id promises; false: its equations are
  /// automatic, for want of generated code.
  bool as_named = true;
  Level level = Level::acceleration;  ///< the highest level at which anyone asks for its unknowns
  /// On ‖Φ‖₂ of its equations: its share, or what rounding leaves if that is more.
  double tolerance = 0;
};

}  // namespace desmo
