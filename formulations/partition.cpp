#include "formulations/partition.h"

#include <stdexcept>

namespace desmo {

namespace {

void require_solution_order(const Mechanism& m) {
  for (const Constraint& c : m.constraints)
    for (const EntityId e : c.operands)
      if (m.entities[e].group > c.group)
        throw std::invalid_argument(m.name + ", group '" + m.groups[c.group].name +
                                    "': constraint '" + c.name + "' needs '" + m.entities[e].name +
                                    "', which a later group finds");
}

void append(PartDefinition& part, const Mechanism& m, GroupId g) {
  part.groups.push_back(g);
  const std::vector<int> found = unknowns(m, g);
  part.unknowns.insert(part.unknowns.end(), found.begin(), found.end());
  for (std::size_t i = 0; i < m.constraints.size(); ++i)
    if (m.constraints[i].group == g) part.equations.push_back(static_cast<int>(i));
}

}  // namespace

std::vector<PartDefinition> make_partition(const Mechanism& m, Partition partition) {
  require_solution_order(m);
  std::vector<PartDefinition> constant, moving;
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g) {
    const bool is_constant = m.groups[g].constant;
    std::vector<PartDefinition>& parts = is_constant ? constant : moving;
    if (is_constant || partition == Partition::group || parts.empty()) parts.emplace_back();
    append(parts.back(), m, g);
    parts.back().constant = is_constant;
  }
  constant.insert(constant.end(), moving.begin(), moving.end());
  return constant;
}

std::vector<bool> constant_coordinates(const Mechanism& m) {
  std::vector<bool> result(m.coordinates(), false);
  for (const Entity& e : m.entities)
    if (!e.fixed && m.groups[e.group].constant)
      for (int i = 0; i < e.size; ++i) result[e.first + i] = true;
  return result;
}

std::vector<int> constraint_of_row(const Mechanism& m, const PartDefinition& part) {
  std::vector<int> result;
  for (const int c : part.equations) result.insert(result.end(), rows(m.constraints[c]), c);
  return result;
}

}  // namespace desmo
