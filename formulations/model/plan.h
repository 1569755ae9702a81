#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/model/model.h"

namespace desmo {

/// An entity whose coordinates are requested.
struct Output {
  EntityId entity;  ///< in the whole model; in Plan::outputs, in the reduced one
  Level level;      ///< highest level requested
};

/// Reduced model that suffices for some outputs, and what was left out of the whole model.
struct Plan {
  /// Use of one group of the whole model.
  struct GroupUse {
    std::string name;                     ///< of the group
    int unknowns = 0, kept_unknowns = 0;  ///< unknowns of the group, and those still solved for
    int blocks = 0, kept_blocks = 0;      ///< irreducible blocks, and those still solved
    Level level = Level::position;        ///< highest level that is needed of it
    /// A dropped block, whose positions nobody looks at, may have no solution, whatever the kept
    /// ones have. Or a dropped equation between constants does not hold.
    bool may_lock = false;
    std::vector<std::string> kept, dropped;  ///< names of its entities
    /// Name of the requested entity for which the first entity is kept that was not requested
    /// itself; empty: all that is kept was requested.
    std::string serves;
  };

  Model model;                   ///< part of the whole model that is solved
  std::vector<Level> levels;     ///< highest level that is needed of each coordinate
  std::vector<Output> outputs;   ///< by their ids in `model`
  std::vector<GroupUse> groups;  ///< groups of the whole model, in solution order

  /// Returns the highest level of the outputs.
  Level level() const;
};

/// Extent of a plan: what it solves besides what its outputs need.
enum class PlanExtent {
  outputs,             ///< nothing
  left_out_equations,  ///< positions that left-out equations of its groups read
  mechanism,           ///< positions of all else
};

/// Reduces a model to what outputs need. Keeps the irreducible blocks upstream of the outputs, with
/// the entities that they determine or read and their drivers. Entities and constraints are kept as
/// a whole. Needed levels propagate upstream: an acceleration needs the accelerations it depends
/// on. Without outputs everything is kept, at the level of acceleration. An entity that is named
/// twice is solved to the higher level, and is in Plan::outputs twice. Left-out equations of what
/// is kept are kept. Throws std::invalid_argument for an entity that the model does not have.
Plan make_plan(const Model& whole, std::span<const Output> outputs,
               PlanExtent extent = PlanExtent::outputs);

}  // namespace desmo
