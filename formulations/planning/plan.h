#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"

namespace desmo {

/// An entity that is asked for, and how far.
struct Asked {
  EntityId entity;
  Level level;
};

/// What has to be solved for what is asked, and no more.
struct Plan {
  /// What became of one group of the whole mechanism.
  struct GroupUse {
    std::string name;
    int unknowns = 0, kept_unknowns = 0;
    int blocks = 0, kept_blocks = 0;         ///< irreducible ones
    Level level = Level::position;           ///< the highest that anything asks of it
    std::vector<std::string> kept, dropped;  ///< entities that it finds
    /// When kept only in part or for others: the first entity asked for that it serves.
    std::string serves;
  };

  Model model;                   ///< the part of the whole that is to be solved
  std::vector<Level> levels;     ///< of each of its coordinates: as far as anything asks
  std::vector<Asked> outputs;    ///< what was asked for, in this mechanism
  std::vector<GroupUse> groups;  ///< of the whole mechanism, in solution order

  /// The highest level that anything asks for.
  Level level() const;
};

/// Keeps the irreducible blocks upstream of what is asked, with the entities that they determine or
/// read and the drivers that they need, and drops everything else. An entity or constraint is kept
/// whole. Needed levels go upstream: an acceleration needs those it depends on.
/// Nothing asked: everything, at the level of acceleration.
Plan make_plan(const Model& whole, std::span<const Asked> asked);

/// What a scene asks for, in its whole mechanism.
std::vector<Asked> asked_by(const Scene& scene, const Model& whole);

}  // namespace desmo
