#include "formulations/model/model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <unordered_set>

#include "cases/mechanism/names.h"
#include "formulations/constraints/kinds.h"
#include "formulations/model/partition.h"

namespace desmo {

namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

}  // namespace

std::string_view component_letters(EntityKind kind) {
  return kind == EntityKind::orientation ? "0123" : "xyz";
}

int Model::structural_groups() const {
  return static_cast<int>(std::ranges::count(groups, false, &Group::constant));
}

EntityId Model::find(const std::string& entity_name) const {
  const auto it = by_name_.find(entity_name);
  require(it != by_name_.end(), name + ": there is no entity '" + entity_name + "'");
  return it->second;
}

Model::Component Model::find_component(const std::string& component_name) const {
  const auto entity = [&](const std::string& entity_name) -> const Entity* {
    const auto it = by_name_.find(entity_name);
    return it == by_name_.end() ? nullptr : &entities[it->second];
  };
  if (const Entity* e = entity(component_name); e && e->size == 1) return {*e, 0};
  if (const auto size = component_name.size(); size > 2 && component_name[size - 2] == '.')
    if (const Entity* e = entity(component_name.substr(0, size - 2)); e && e->size > 1)
      if (const auto i = component_letters(e->kind).find(component_name.back());
          i < static_cast<std::size_t>(e->size))
        return {*e, static_cast<int>(i)};
  std::vector<std::string> names;
  for (EntityId e = 0; e < static_cast<EntityId>(entities.size()); ++e)
    for (int i = 0; i < entities[e].size; ++i)
      names.push_back(coordinate_name(*this, e, entities[e].first + i));
  throw std::invalid_argument(
      name + ": there is no coordinate '" + component_name + "'; " +
      suggestion(component_name, std::vector<std::string_view>(names.begin(), names.end())));
}

int Model::coordinate(const std::string& component_name) const {
  const auto [entity, i] = find_component(component_name);
  require(!entity.fixed, name + ": '" + component_name + "' is fixed and no coordinate");
  return entity.first + i;
}

double Model::value(const std::string& component_name, std::span<const double> values,
                    Level level) const {
  require(std::ssize(values) == coordinates(), name + ": there are " +
                                                   std::to_string(values.size()) + " values for " +
                                                   std::to_string(coordinates()) + " coordinates");
  const auto [entity, i] = find_component(component_name);
  if (!entity.fixed) return values[entity.first + i];
  return level == Level::position ? fixed_values[entity.first + i] : 0;
}

std::vector<double> Model::state_of(std::span<const double> q) const {
  std::vector<double> state(q.begin(), q.end());
  state.insert(state.end(), fixed_values.begin(), fixed_values.end());
  return state;
}

GroupId Model::add_group(std::string group_name, std::vector<std::string> bodies) {
  groups.push_back({std::move(group_name), std::move(bodies), {}, {}, false});
  return static_cast<GroupId>(groups.size()) - 1;
}

EntityId Model::add_entity(Entity entity) {
  const EntityId id = static_cast<EntityId>(entities.size());
  by_name_.try_emplace(entity.name, id);
  entities.push_back(std::move(entity));
  return id;
}

EntityId Model::add(EntityKind kind, std::string entity_name,
                    std::span<const double> initial_estimate, GroupId group) {
  const EntityId id = add_entity({std::move(entity_name), kind, false, coordinates(),
                                  static_cast<int>(initial_estimate.size()), group});
  estimate.insert(estimate.end(), initial_estimate.begin(), initial_estimate.end());
  return id;
}

EntityId Model::add_fixed(EntityKind kind, std::string entity_name, std::span<const double> values,
                          std::span<const Remainder> remainders) {
  const EntityId id =
      add_entity({std::move(entity_name), kind, true, static_cast<int>(fixed_values.size()),
                  static_cast<int>(values.size()), no_position});
  fixed_values.insert(fixed_values.end(), values.begin(), values.end());
  fixed_remainders.insert(fixed_remainders.end(), remainders.begin(), remainders.end());
  fixed_remainders.resize(fixed_values.size());
  return id;
}

void Model::drive(EntityId coordinate, Motion motion) {
  const Entity& e = entities.at(coordinate);
  require(e.size == 1 && !e.fixed, "driver of '" + e.name + "': not a scalar coordinate");
  drivers.push_back({coordinate, motion});
}

void Model::add(Constraint constraint) {
  const std::string where = "constraint '" + constraint.name + "'";
  const std::span<const int> sizes = description_of(constraint.kind).operand_sizes;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const Entity& e = entities.at(constraint.operands.at(k));
    require(e.size == sizes[k], where + ": '" + e.name + "' has " + std::to_string(e.size) +
                                    " components, not " + std::to_string(sizes[k]));
  }
  require(std::ranges::all_of(constraint.constants,
                              [](const Derived& c) { return std::isfinite(c.value); }),
          where + ": a dimension is not finite");
  constraints.push_back(std::move(constraint));
}

std::string coordinate_name(const Model& m, EntityId entity, int coordinate) {
  const Entity& e = m.entities[entity];
  return e.size == 1 ? e.name : e.name + "." + component_letters(e.kind)[coordinate - e.first];
}

std::vector<EntityId> entity_of_coordinate(const Model& m) {
  std::vector<EntityId> result(m.coordinates());
  for (EntityId e = 0; e < static_cast<EntityId>(m.entities.size()); ++e)
    for (int i = 0; !m.entities[e].fixed && i < m.entities[e].size; ++i)
      result[m.entities[e].first + i] = e;
  return result;
}

std::vector<bool> independent_coordinates(const Model& m) {
  std::vector<bool> independent(m.coordinates(), false);
  for (const Driver& d : m.drivers) independent[m.entities[d.coordinate].first] = true;
  return independent;
}

std::vector<bool> coupled_angles(const Model& m) {
  std::vector<bool> coupled(m.entities.size(), false);
  for (const Constraint& c : m.constraints) {
    const KindDescription& kind = description_of(c.kind);
    if (!kind.linear && kind.table < 0) continue;
    for (const EntityId e : c.operands)
      if (m.entities[e].kind == EntityKind::angle) coupled[e] = true;
  }
  return coupled;
}

std::string_view constraint_kind_name(int kind) { return description_of(kind).name; }

int rows(const Constraint& constraint) { return description_of(constraint.kind).rows; }

bool is_linear(const Constraint& constraint) { return description_of(constraint.kind).linear; }

int kept_rows(const Constraint& constraint) {
  return rows(constraint) - std::popcount(constraint.left_out);
}

bool is_constant(const Model& m, const Constraint& c) {
  return std::ranges::all_of(c.operands, [&m](EntityId e) { return m.entities[e].fixed; });
}

void require_natural(const Model& m) {
  require(m.modelling == Modelling::natural,
          m.name + ": natural coordinates alone can be checked; ask for no checks");
}

void validate(const Model& m) {
  std::unordered_set<std::string> names;
  for (const Entity& e : m.entities)
    require(names.insert(e.name).second, m.name + ": two entities are named '" + e.name + "'");
  require(all_finite(m.estimate), m.name + ": the initial estimate is not finite");
  require(all_finite(m.fixed_values), m.name + ": a fixed point or vector is not finite");
  require(std::ranges::is_sorted(m.constraints, {}, &Constraint::group),
          m.name + ": constraints are not in the order of their groups");

  std::vector<int> equations(m.groups.size(), 0), found(m.groups.size(), 0);
  for (const Constraint& c : m.constraints) equations.at(c.group) += kept_rows(c);
  const std::vector<bool> independent = independent_coordinates(m);
  for (const Entity& e : m.entities)
    for (int i = 0; !e.fixed && i < e.size; ++i) found.at(e.group) += !independent[e.first + i];
  for (std::size_t g = 0; g < m.groups.size(); ++g)
    require(equations[g] == found[g],
            m.name + ", group '" + m.groups[g].name + "': " + std::to_string(equations[g]) +
                " equations for " + std::to_string(found[g]) + " unknowns (" +
                (equations[g] > found[g] ? "over" : "under") + "-constrained)");
  if (std::ranges::count(m.constraints, no_position, &Constraint::derives) ==
      std::ssize(m.constraints))
    return;
  Model kept = m;
  keep_derivations(kept);
  for (std::size_t c = 0; c < m.constraints.size(); ++c)
    if (const Constraint& given = m.constraints[c]; given.derives != kept.constraints[c].derives)
      throw std::invalid_argument(m.name + ", constraint '" + given.name + "': it cannot derive '" +
                                  m.entities[derived_entity(given)].name + "'");
}

}  // namespace desmo
