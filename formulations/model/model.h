#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/constraints/constraints.h"

namespace desmo {

template <class Kind>
constexpr int kind_index();  // constraints.h

using EntityId = int;  ///< position in Model::entities
using GroupId = int;   ///< position in Model::groups

enum class EntityKind { point, vector, angle, distance };

/// A named geometric quantity. Its components are coordinates, or constants when it is fixed.
struct Entity {
  std::string name;
  EntityKind kind;
  bool fixed;
  int first;      ///< first component, in q or (fixed) in Model::fixed_values
  int size;       ///< 2 or 3 for points and vectors, 1 for angles and distances
  GroupId group;  ///< the group whose solution yields it; -1 when fixed
};

/// One constraint: a kind applied to entities, with its dimensions.
struct Constraint {
  std::string name;
  int kind;  ///< position in ConstraintKinds
  std::vector<EntityId> operands;
  std::vector<double> constants;
  GroupId group;          ///< the group that it determines
  unsigned left_out = 0;  ///< bit r: row r depends on other equations and is not one
};

/// A structural group: a chain that is kinematically determinate once the groups before it are
/// solved (paper, section 2).
struct Group {
  std::string name;
  std::vector<std::string> bodies;
  std::vector<EntityId> entities;  ///< what models it, as the paper counts them
  std::vector<GroupId> after;      ///< groups to whose bodies its own are joined: solved before it
  bool constant = false;           ///< depends on no driver; not counted as a structural group
};

/// An independent coordinate and its prescribed motion.
struct Driver {
  EntityId coordinate;
  Motion motion;
};

/// A model of a mechanism as plain data: coordinates q, constraint equations Φ(q) = 0 by structural
/// group in solution order, and drivers. Everything that solves it reads it as const.
///
/// The *state* is q followed by the components of the fixed entities, so that constraints read
/// both alike.
struct Model {
  std::string name;
  std::string length_unit = "m";  ///< "1": any one unit
  std::vector<Entity> entities;
  std::vector<Constraint> constraints;  ///< those of one group stand together, in group order
  std::vector<Group> groups;            ///< in solution order
  std::vector<Driver> drivers;
  std::vector<double> estimate;      ///< initial estimate of q, as long as q
  std::vector<double> fixed_values;  ///< components of the fixed entities

  int coordinates() const { return static_cast<int>(estimate.size()); }
  int degrees_of_freedom() const { return static_cast<int>(drivers.size()); }
  int state_size() const { return coordinates() + static_cast<int>(fixed_values.size()); }

  /// Position of the entity's first component in the state.
  int state_index(EntityId e) const {
    return entities[e].fixed ? coordinates() + entities[e].first : entities[e].first;
  }

  /// Whether an entity never moves: fixed, or of a constant group.
  bool rests(EntityId e) const { return entities[e].fixed || groups[entities[e].group].constant; }

  /// Structural groups, the constant ones left out (as the paper counts).
  int structural_groups() const;

  /// The entity of that name. Throws std::invalid_argument when there is none.
  EntityId find(const std::string& entity_name) const;

  GroupId add_group(std::string group_name, std::vector<std::string> bodies);

  /// Adds an entity whose components are coordinates, initially estimated, found by a group.
  EntityId add(EntityKind kind, std::string entity_name, std::span<const double> initial_estimate,
               GroupId group);
  /// Adds an entity that never moves.
  EntityId add_fixed(EntityKind kind, std::string entity_name, std::span<const double> values);
  /// Prescribes the motion of a scalar coordinate.
  void drive(EntityId coordinate, Motion motion);

  /// Adds a constraint of a group. Throws std::invalid_argument, naming the constraint, when an
  /// operand has not the size that the kind needs or a constant is not finite.
  template <class Kind>
  void constrain(GroupId group, std::string constraint_name,
                 const std::array<EntityId, Kind::operand_sizes.size()>& operands,
                 const std::array<double, Kind::constants>& constants = {}) {
    add_constraint({std::move(constraint_name),
                    kind_index<Kind>(),
                    {operands.begin(), operands.end()},
                    {constants.begin(), constants.end()},
                    group,
                    0},
                   Kind::operand_sizes);
  }

 private:
  EntityId add_entity(Entity entity);
  void add_constraint(Constraint constraint, std::span<const int> operand_sizes);

  std::unordered_map<std::string, EntityId> by_name_;  // the first of that name
};

/// For each coordinate, the entity that it belongs to.
std::vector<EntityId> entity_of_coordinate(const Model& model);

/// For each coordinate, whether it is driven.
std::vector<bool> independent_coordinates(const Model& model);

/// Scalar equations of a constraint, those left out included.
int rows(const Constraint& constraint);
/// Scalar equations of a constraint, without those left out.
int kept_rows(const Constraint& constraint);

/// The coordinates that a group solves for, ascending; independent ones are left out.
std::vector<int> unknowns(const Model& model, GroupId group);

/// Throws std::invalid_argument, naming the offender, unless names are unique, values are finite,
/// constraints stand in group order, and every group has as many equations as unknowns.
void validate(const Model& model);

}  // namespace desmo
