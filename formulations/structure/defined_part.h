#pragma once

#include <memory>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// A part of a formulation: its definition (unknowns, equations) and its solver.
struct DefinedPart {
  PartDefinition definition;
  std::unique_ptr<Part> solver;
  /// The solver is of the kind that the formulation's id names. False when generated code was
  /// missing and automatic equations stand in for it.
  bool as_named = true;
  Level level = Level::acceleration;  ///< highest level at which its unknowns are requested
  /// Tolerance on ‖Φ‖₂ of its weighted equations: its share of the whole, or what rounding leaves.
  double tolerance = 0;
};

class Formulation;

/// Returns the parts of a formulation in the order of solution.
const std::vector<DefinedPart>& parts_of(const Formulation& formulation);

}  // namespace desmo
