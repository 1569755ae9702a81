#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/base/settings.h"
#include "formulations/model/model.h"

namespace desmo {

// A *part* is a square subsystem of Φ(q) = 0, solved after all earlier parts. A *partition* cuts
// the model into parts.

/// A scalar equation of the model.
struct Equation {
  int constraint;  ///< position in Model::constraints
  int row;         ///< row within that constraint
  auto operator<=>(const Equation&) const = default;
};

/// The definition of a part: n unknowns and n scalar equations.
struct PartDefinition {
  std::vector<GroupId> groups;      ///< structural groups that it belongs to
  std::vector<int> unknowns;        ///< coordinates solved for, ascending
  std::vector<Equation> equations;  ///< ascending
  bool constant = false;            ///< depends on no driver: solved once, at assembly

  /// Appends the groups, unknowns and equations of another part; does not sort them.
  void append(const PartDefinition& part);
};

/// A part of a formulation: its definition (unknowns, equations) and its solver.
struct DefinedPart {
  PartDefinition definition;
  std::unique_ptr<Part> solver;
  /// The solver is of the kind that the formulation's id names. False when generated code was
  /// missing and another kind stands in for it.
  bool as_named = true;
  Level level = Level::acceleration;  ///< highest level at which its unknowns are requested
  /// Tolerance on ‖Φ‖₂ of its weighted equations: its share of the whole or, if larger, its
  /// rounding floor.
  double tolerance = 0;
};

/// Returns the parts of a partition in solution order. Constant groups come first, each a part of
/// its own; groups of drivers only are omitted. In other than natural coordinates, moving parts are
/// cut by split_outputs(), except with Partition::block. Throws std::invalid_argument when a group
/// needs a coordinate of a later group, or (Partition::block) is structurally singular.
std::vector<PartDefinition> make_partition(const Model& model, Partition partition);

/// Cuts a part into one part per group, in solution order.
std::vector<PartDefinition> split_by_group(const Model& model, const PartDefinition& part);

/// Returns the state indices that a part's equations read, ascending; its unknowns are included.
std::vector<int> states_read(const Model& model, const PartDefinition& part);

/// Returns the inputs of a part's equations: all its unknowns as `predicted`, every other variable,
/// driven or not, as `others`.
PartInputs equation_inputs(const Model& model, const PartDefinition& part);

/// Returns the irreducible blocks of a part's equations in solution order: the strong components of
/// a matching of equations with unknowns (block triangular form; Dulmage & Mendelsohn 1958,
/// computed by CXSparse). Throws std::invalid_argument, naming an unknown or constraint without a
/// match, when the part is structurally singular.
std::vector<PartDefinition> irreducible_blocks(const Model& model, const PartDefinition& part);

// ---- Derivations (Constraint::derives) ----

/// Makes closures of constraints that cannot be derivations: sets Constraint::derives to
/// no_position where
/// - coordinates are natural,
/// - the constraint is not explicit in the entity: its derivatives by the entity are not a diagonal
///   matrix with entries ±1,
/// - a row is left out,
/// - the entity is driven, fixed, of another group, or derived by an earlier constraint,
/// - the entity would be derived from itself, by way of earlier derivations.
void keep_derivations(Model& model);

/// A derived unknown of a part and the equation that is explicit in it.
struct Derivation {
  int row;     ///< position among the part's equations
  int column;  ///< position among the part's unknowns
};

/// Returns the derivations of a part, in an order in which each reads only unknowns that are not
/// derived, or are derived before.
std::vector<Derivation> derivations(const Model& model, const PartDefinition& part);

/// Cuts a part in two: the closures with all derivations that they need, then all other
/// derivations. Only outputs and later parts read the unknowns of the second. A part without
/// unknowns is omitted.
std::vector<PartDefinition> split_outputs(const Model& model, const PartDefinition& part);

}  // namespace desmo
