#pragma once

#include <span>
#include <string>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/model/model.h"

namespace desmo {

/// How the unknowns are cut.
enum class Partition {
  global,  ///< all structural groups at once
  group,   ///< the structural groups one after the other
  block,   ///< the irreducible blocks of each group's equations one after the other
};

/// How equations are evaluated.
enum class Evaluation {
  automatic,  ///< by a loop over constraint objects
  symbolic,   ///< by generated straight-line code
};

/// One scalar equation.
struct Equation {
  int constraint;  ///< position in Model::constraints
  int row;         ///< of that constraint
  bool operator==(const Equation&) const = default;
};

/// What one part of a formulation solves: as many scalar equations as unknowns.
struct PartDefinition {
  std::vector<GroupId> groups;
  std::vector<int> unknowns;        ///< coordinates solved for, ascending
  std::vector<Equation> equations;  ///< ascending
  bool constant = false;            ///< depends on no driver: solved once, at assembly
};

/// The parts of a partition in solution order; constant groups come first, each on its own.
/// Throws std::invalid_argument when a group needs a coordinate that is found after it, or when its
/// equations cannot determine its unknowns whatever the numbers are.
std::vector<PartDefinition> make_partition(const Model& model, Partition partition);

/// A part cut into what belongs to each of its groups, in solution order.
std::vector<PartDefinition> split_by_group(const Model& model, const PartDefinition& part);

/// Positions in the state of all that a part's equations read, ascending, its unknowns among them.
std::vector<int> states_read(const Model& model, const PartDefinition& part);

/// Returns what a part's equations read: its unknowns, as predicted, and others, drivers among
/// them.
PartInputs equation_inputs(const Model& model, const PartDefinition& part);

/// The irreducible blocks of a part's equations in solution order: the strong components of a
/// matching of equations with unknowns (block triangular form; Dulmage & Mendelsohn 1958, as
/// CXSparse computes it). Throws std::invalid_argument, naming what cannot be matched, when the
/// part is structurally singular.
std::vector<PartDefinition> irreducible_blocks(const Model& model, const PartDefinition& part);

}  // namespace desmo
