#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cases/mechanism/level.h"
#include "cases/mechanism/motion.h"
#include "cases/numbers/derived.h"
#include "formulations/base/settings.h"

namespace desmo {

using EntityId = int;  ///< position in Model::entities
using GroupId = int;   ///< position in Model::groups

/// The position of a group, an entity, a constraint or a coordinate that does not exist or is not
/// known.
inline constexpr int no_position = -1;

/// Kinds of entities. An orientation is four Euler parameters.
enum class EntityKind { point, vector, angle, distance, orientation };
/// Returns the letters of components in names: "xyz", or "0123" of an orientation.
std::string_view component_letters(EntityKind kind);

/// A named geometric quantity. Its components are coordinates, or constants if it is fixed.
struct Entity {
  std::string name;
  EntityKind kind;
  bool fixed;
  int first;      ///< first component, in q or (fixed) in Model::fixed_values
  int size;       ///< 2 or 3 for points and vectors, 1 for angles and distances, 4 for orientations
  GroupId group;  ///< group whose solution yields it; no_position when fixed
  bool internal = false;  ///< serves the model alone: the mechanism has nothing of that name
};

/// The source of an equation. Earlier values are preferred when equations are selected.
enum class EquationSource { ground, coordinate, joint, body };

/// A constraint: a kind applied to entities, with its dimensions.
struct Constraint {
  std::string name;
  int kind;  ///< position in ConstraintKinds; constraint_kind_name() returns its name
  std::vector<EntityId> operands;
  std::vector<Derived> constants;  ///< dimensions; formulations use their values alone
  GroupId group;                   ///< group that it determines
  /// Bit r: row r is omitted. It depends on other equations, or is between constants.
  unsigned left_out = 0;
  /// Bound on the error of each row of Φ that the limited digits of the file cause; empty: 0. Only
  /// proofs use it.
  std::vector<double> slack{};
  /// Position of the operand that Φ is explicit in (∂Φ/∂operand: diagonal, ±1): the constraint is a
  /// *derivation* of it from the others. no_position: the constraint is a *closure*.
  int derives = no_position;
  /// Φ₀ of each row in Newton's homotopy Φ(q, t) = (1 − t) Φ₀; empty: Φ(q, t) = 0. Only proofs use
  /// it.
  std::vector<double> initial_residual{};
  EquationSource source = EquationSource::ground;  ///< only the selection of equations reads it
};

/// A structural group: a kinematic chain that is determinate once the groups before it are solved
/// (paper, section 2).
struct Group {
  std::string name;
  std::vector<std::string> bodies;
  std::vector<EntityId> entities;  ///< those of its bodies and joints, as the paper counts them
  std::vector<GroupId> after;      ///< earlier groups whose bodies are joined to its own
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
///
/// The vectors may be changed directly; validate() then checks them. has() and find() know only the
/// names that add() and add_fixed() were given.
struct Model {
  std::string name;
  std::string length_unit = "m";  ///< name of the unit of length; "1": none is named
  Modelling modelling = Modelling::natural;
  std::vector<Entity> entities;
  std::vector<Constraint> constraints;  ///< contiguous by group, in group order
  std::vector<Group> groups;            ///< in solution order
  std::vector<Driver> drivers;
  std::vector<double> estimate;      ///< initial estimate of q (coordinates())
  std::vector<double> fixed_values;  ///< components of the fixed entities
  /// Remainder of each fixed value: the file's number minus the value.
  std::vector<Remainder> fixed_remainders;

  int coordinates() const { return static_cast<int>(estimate.size()); }
  int degrees_of_freedom() const { return static_cast<int>(drivers.size()); }
  int state_size() const { return coordinates() + static_cast<int>(fixed_values.size()); }

  /// Returns the position of the entity's first component in the state.
  int state_index(EntityId e) const {
    return entities[e].fixed ? coordinates() + entities[e].first : entities[e].first;
  }

  /// Returns a component of a fixed entity as the file means it. i: position in fixed_values.
  Derived fixed_value(std::size_t i) const { return {fixed_values[i], fixed_remainders[i]}; }

  /// Returns the state at positions q (coordinates()): q, then the fixed values (state_size()).
  std::vector<double> state_of(std::span<const double> q) const;

  /// Returns whether an entity never moves: it is fixed, or its group is constant.
  bool is_at_rest(EntityId e) const {
    return entities[e].fixed || groups[entities[e].group].constant;
  }

  /// Returns the number of structural groups without the constant ones, as the paper counts.
  int structural_groups() const;

  /// Returns whether an entity was added with that name.
  bool has(const std::string& entity_name) const { return by_name_.contains(entity_name); }

  /// Returns the first entity that was added with that name. Throws std::invalid_argument when
  /// there is none.
  EntityId find(const std::string& entity_name) const;

  /// Returns the position in q, q̇ and q̈ of a coordinate by its name (coordinate_name()): "C.x", a
  /// component of a point or vector C, or "theta", an angle or a distance. Look it up once, before
  /// a loop. Throws std::invalid_argument when it is fixed, or when there is none; the message then
  /// suggests names that exist.
  int coordinate(const std::string& name) const;

  /// Returns the value of that name at a level, where `values` are q, q̇ or q̈. A fixed entity has
  /// its constants, and rates 0. Throws std::invalid_argument when there is no such name or
  /// `values` are not coordinates() numbers.
  ///
  ///   model.value("C.x", instant.q), model.value("C.x", instant.qd, Level::velocity)
  double value(const std::string& name, std::span<const double> values,
               Level level = Level::position) const;

  /// Adds a group after all others. Returns its position.
  GroupId add_group(std::string group_name, std::vector<std::string> bodies);

  /// Adds an entity whose components are coordinates. They have an initial estimate, and a group
  /// whose solution yields them.
  EntityId add(EntityKind kind, std::string entity_name, std::span<const double> initial_estimate,
               GroupId group);
  /// Adds an entity that never moves. remainders: one for each value; empty: all are 0.
  EntityId add_fixed(EntityKind kind, std::string entity_name, std::span<const double> values,
                     std::span<const Remainder> remainders = {});
  /// Prescribes the motion of a scalar coordinate. Throws std::invalid_argument for any other
  /// entity.
  void drive(EntityId coordinate, Motion motion);

  /// Adds a constraint after all others; validate() checks that those of a group follow each other.
  /// Throws std::invalid_argument, naming the constraint, when an operand has another size than the
  /// kind needs or a constant is not finite.
  void add(Constraint constraint);

 private:
  EntityId add_entity(Entity entity);

  /// A component of an entity: the i-th of its values.
  struct Component {
    const Entity& entity;
    int i;
  };
  Component find_component(const std::string& component_name) const;

  std::unordered_map<std::string, EntityId> by_name_;  // first entity added with each name
};

/// Returns the name of a coordinate of an entity: "C.x" of a point or vector C, or the entity's
/// own.
std::string coordinate_name(const Model& model, EntityId entity, int coordinate);

/// Returns the entity of each coordinate.
std::vector<EntityId> entity_of_coordinate(const Model& model);

/// Returns for each coordinate whether it is driven.
std::vector<bool> independent_coordinates(const Model& model);

/// Returns for each entity whether it is an angle whose whole turns count: a coupling, which is
/// linear or by a table, relates it.
std::vector<bool> coupled_angles(const Model& model);

/// Returns the name of a kind of constraint, such as "distance2".
std::string_view constraint_kind_name(int kind);

/// Returns the number of scalar equations of a constraint, omitted ones included.
int rows(const Constraint& constraint);
/// Returns whether the derivatives of a constraint do not depend on positions.
bool is_linear(const Constraint& constraint);
/// Returns the number of scalar equations of a constraint without omitted ones.
int kept_rows(const Constraint& constraint);

/// Returns whether a constraint is between fixed entities alone. It determines nothing: modelling
/// leaves out all of its rows, and puts it after the others of its group.
bool is_constant(const Model& model, const Constraint& constraint);

/// Throws std::invalid_argument unless coordinates are natural: proofs exist for these alone.
void require_natural(const Model& model);

/// Returns the entity that a constraint derives; no_position: it is a closure.
inline EntityId derived_entity(const Constraint& c) {
  return c.derives < 0 ? no_position : c.operands[c.derives];
}

/// Checks that names are unique, values are finite, constraints stand in group order, every group
/// has as many equations as unknowns, and derivations are as keep_derivations() leaves them. Throws
/// std::invalid_argument, naming the offender.
void validate(const Model& model);

}  // namespace desmo
