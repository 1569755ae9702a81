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
    std::string name;                     ///< name of the group
    int unknowns = 0, kept_unknowns = 0;  ///< unknowns of the group, and those still solved for
    int blocks = 0, kept_blocks = 0;  ///< irreducible blocks of the group, and those still solved
    Level level = Level::position;    ///< highest level that is needed of it
    /// True where a dropped block may have no solution although the kept ones have one. True also
    /// where a dropped equation between constants may not hold.
    bool may_lock = false;
    std::vector<std::string> kept, dropped;  ///< names of its kept and dropped entities
    /// The first kept entity that is no output serves another entity, usually an output: the name
    /// of that one. Empty: all kept entities are outputs.
    std::string serves;
  };

  Model model;                   ///< part of the whole model that is solved
  std::vector<Level> levels;     ///< highest level that is needed of each coordinate
  std::vector<Output> outputs;   ///< the requested outputs, with ids of entities in `model`
  std::vector<GroupUse> groups;  ///< groups of the whole model, in solution order

  /// Returns the highest level of the outputs.
  Level level() const;
};

/// Extent of a plan: what it solves besides what its outputs need.
enum class PlanExtent {
  outputs,             ///< nothing else
  left_out_equations,  ///< positions that left-out equations of its groups read
  mechanism,           ///< positions of all other entities
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
