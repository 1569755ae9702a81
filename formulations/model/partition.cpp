#include "formulations/model/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "formulations/base/index_range.h"
#include "formulations/model/constraint_at.h"

namespace desmo {

namespace {

void require_solution_order(const Model& m) {
  for (const Constraint& c : m.constraints)
    for (const EntityId e : c.operands)
      if (m.entities[e].group > c.group)
        throw std::invalid_argument(m.name + ", group '" + m.groups[c.group].name +
                                    "': constraint '" + c.name + "' needs '" + m.entities[e].name +
                                    "', which a later group finds");
}

/// Returns each group as one part, in the order of the groups.
std::vector<PartDefinition> whole_groups(const Model& m) {
  std::vector<PartDefinition> parts(m.groups.size());
  for (GroupId g = 0; g < static_cast<GroupId>(parts.size()); ++g) {
    parts[g].groups = {g};
    parts[g].constant = m.groups[g].constant;
  }
  const std::vector<bool> independent = independent_coordinates(m);
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
      if (!independent[i]) parts[e.group].unknowns.push_back(i);
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
    for (int row = 0; row < rows(m.constraints[c]); ++row)
      if (!(m.constraints[c].left_out >> row & 1))
        parts[m.constraints[c].group].equations.push_back({c, row});
  for (PartDefinition& p : parts) std::ranges::sort(p.unknowns);
  return parts;
}

/// Returns whether a constraint is explicit in the entity e that it derives: ∂Φ/∂e is diagonal with
/// entries ±1. size: number of components of e.
bool is_explicit(const Constraint& c, int size) {
  static constexpr std::array<double, max_components> ones{1, 1, 1, 1};
  std::array<const double*, max_operands> x;
  x.fill(ones.data());
  bool result = true;
  int entries = 0;
  ConstraintAt<double>(c, x).jacobian([&](int row, int operand, int component, double value) {
    if (operand != c.derives) return;
    ++entries;
    result = result && row == component && std::abs(value) == 1;
  });
  return result && entries == rows(c) && entries == size;
}

/// Returns for each entity whether it is among `ends`, or one of these is derived from it, directly
/// or by way of others. deriving: constraint that derives each entity; no_position: none
std::vector<bool> ends_and_sources(const Model& m, const std::vector<int>& deriving,
                                   std::vector<EntityId> ends) {
  std::vector<bool> found(m.entities.size(), false);
  while (!ends.empty()) {
    const EntityId e = ends.back();
    ends.pop_back();
    if (found[e]) continue;
    found[e] = true;
    if (deriving[e] < 0) continue;
    const std::vector<EntityId>& operands = m.constraints[deriving[e]].operands;
    ends.insert(ends.end(), operands.begin(), operands.end());
  }
  return found;
}

}  // namespace

void PartDefinition::append(const PartDefinition& part) {
  groups.insert(groups.end(), part.groups.begin(), part.groups.end());
  unknowns.insert(unknowns.end(), part.unknowns.begin(), part.unknowns.end());
  equations.insert(equations.end(), part.equations.begin(), part.equations.end());
}

std::vector<PartDefinition> make_partition(const Model& m, Partition partition) {
  require_solution_order(m);
  std::vector<PartDefinition> constant, moving;
  for (PartDefinition& group : whole_groups(m)) {
    if (group.unknowns.empty() && group.equations.empty()) continue;  // it has drivers only
    if (group.constant) {
      constant.push_back(std::move(group));
    } else if (partition == Partition::block) {
      std::ranges::move(irreducible_blocks(m, group), std::back_inserter(moving));
    } else if (partition == Partition::group || moving.empty()) {
      moving.push_back(std::move(group));
    } else {
      moving.front().append(group);
    }
  }
  if (partition == Partition::global && !moving.empty()) std::ranges::sort(moving.front().unknowns);
  for (PartDefinition& part : moving) {
    if (m.modelling == Modelling::natural || partition == Partition::block)
      constant.push_back(std::move(part));
    else
      std::ranges::move(split_outputs(m, part), std::back_inserter(constant));
  }
  return constant;
}

std::vector<PartDefinition> split_by_group(const Model& m, const PartDefinition& part) {
  if (part.groups.size() == 1) return {part};
  std::map<GroupId, PartDefinition> groups;
  for (const GroupId g : part.groups) groups[g] = {{g}, {}, {}, part.constant};
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (const int i : part.unknowns) groups.at(m.entities[owner[i]].group).unknowns.push_back(i);
  for (const Equation& e : part.equations)
    groups.at(m.constraints[e.constraint].group).equations.push_back(e);
  std::vector<PartDefinition> result;
  for (auto& [g, definition] : groups) result.push_back(std::move(definition));
  return result;
}

std::vector<int> states_read(const Model& m, const PartDefinition& part) {
  std::vector<int> read = part.unknowns;
  for (const Equation& equation : part.equations)
    for (const EntityId e : m.constraints[equation.constraint].operands)
      for (int i = 0; i < m.entities[e].size; ++i) read.push_back(m.state_index(e) + i);
  std::ranges::sort(read);
  read.erase(std::ranges::unique(read).begin(), read.end());
  return read;
}

PartInputs equation_inputs(const Model& m, const PartDefinition& part) {
  PartInputs inputs{.predicted = part.unknowns, .unwrapped = {}, .others = {}, .drivers = {}};
  std::ranges::set_difference(states_read(m, part), part.unknowns,
                              std::back_inserter(inputs.others));
  return inputs;
}

// ---- Derivations ----

void keep_derivations(Model& m) {
  const std::vector<bool> independent = independent_coordinates(m);
  std::vector<int> deriving(m.entities.size(), no_position);
  const auto can_derive = [&](const Constraint& c, EntityId id) {
    const Entity& e = m.entities[id];
    if (m.modelling == Modelling::natural || c.left_out || e.fixed || e.group != c.group ||
        independent[e.first] || deriving[id] >= 0 || !is_explicit(c, e.size))
      return false;
    std::vector<EntityId> others = c.operands;
    std::erase(others, id);
    return !ends_and_sources(m, deriving, others)[id];
  };
  for (int i = 0; i < static_cast<int>(m.constraints.size()); ++i) {
    Constraint& c = m.constraints[i];
    if (c.derives < 0) continue;
    if (const EntityId id = derived_entity(c); can_derive(c, id))
      deriving[id] = i;
    else
      c.derives = no_position;
  }
}

std::vector<Derivation> derivations(const Model& m, const PartDefinition& part) {
  // Each equation counts by itself: Partition::block may put equations of one constraint into
  // several parts.
  std::vector<std::vector<Derivation>> of_entity(m.entities.size());
  const auto constraint_of = [&](const Equation& e) -> const Constraint& {
    return m.constraints[e.constraint];
  };
  for (std::size_t row = 0; row < part.equations.size(); ++row) {
    const EntityId e = derived_entity(constraint_of(part.equations[row]));
    if (e < 0) continue;
    const int column = position_in(part.unknowns, m.entities[e].first + part.equations[row].row);
    if (column >= 0) of_entity[e].push_back({static_cast<int>(row), column});
  }
  std::vector<Derivation> result;
  const auto append = [&](auto&& self, EntityId e) -> void {
    const std::vector<Derivation> own = std::exchange(of_entity[e], {});  // appended once
    if (own.empty()) return;
    for (const EntityId operand : constraint_of(part.equations[own.front().row]).operands)
      self(self, operand);
    result.insert(result.end(), own.begin(), own.end());
  };
  for (const Equation& equation : part.equations)
    if (const EntityId e = derived_entity(constraint_of(equation)); e >= 0) append(append, e);
  return result;
}

std::vector<PartDefinition> split_outputs(const Model& m, const PartDefinition& part) {
  std::vector<int> deriving(m.entities.size(), no_position);  // by constraints of the part
  std::vector<EntityId> of_closures;
  for (const Equation& equation : part.equations) {
    const Constraint& c = m.constraints[equation.constraint];
    if (c.derives < 0)
      of_closures.insert(of_closures.end(), c.operands.begin(), c.operands.end());
    else
      deriving[derived_entity(c)] = equation.constraint;
  }
  const std::vector<bool> needed = ends_and_sources(m, deriving, std::move(of_closures));
  const auto is_output = [&](EntityId e) { return deriving[e] >= 0 && !needed[e]; };

  PartDefinition core{part.groups, {}, {}, part.constant}, outputs = core;
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (const int i : part.unknowns) (is_output(owner[i]) ? outputs : core).unknowns.push_back(i);
  for (const Equation& e : part.equations) {
    const EntityId derived = derived_entity(m.constraints[e.constraint]);
    (derived >= 0 && is_output(derived) ? outputs : core).equations.push_back(e);
  }
  std::vector<PartDefinition> result;
  for (PartDefinition* p : {&core, &outputs})
    if (!p->unknowns.empty()) result.push_back(std::move(*p));
  return result;
}

}  // namespace desmo
