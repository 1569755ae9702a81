#include "formulations/model/partition.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>


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

}  // namespace desmo
