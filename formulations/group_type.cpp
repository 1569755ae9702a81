#include "formulations/group_type.h"

#include <algorithm>
#include <map>

#include "formulations/partition.h"

namespace desmo {

namespace {

std::string local_name(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  return slash == std::string::npos ? name : name.substr(slash + 1);
}

std::string component_name(const Entity& e, int component) {
  return local_name(e.name) + (e.size > 1 ? std::string(".") + "xyz"[component] : "");
}

}  // namespace

GroupType describe_group(const Mechanism& m, GroupId group) {
  const std::vector<bool> constant = constant_coordinates(m);
  const std::vector<int> found = unknowns(m, group);
  const auto role = [&](const Entity& e) {
    if (e.fixed || constant[e.first])
      return m.groups[group].constant && e.group == group ? Role::unknown : Role::fixed;
    return std::ranges::binary_search(found, e.first) ? Role::unknown : Role::known;
  };

  GroupType type;
  std::map<EntityId, int> first_input;
  for (const Constraint& c : m.constraints) {
    if (c.group != group) continue;
    GroupType::Equation equation{c.kind, {}, static_cast<int>(type.constants.size())};
    visit_kind(c.kind, [&](auto kind) {
      type.fingerprint += std::string(kind.name) + '(';
      type.rows += kind.rows;
    });
    for (const EntityId id : c.operands) {
      const Entity& e = m.entities[id];
      const auto [it, is_new] = first_input.try_emplace(id, static_cast<int>(type.inputs.size()));
      for (int i = 0; is_new && i < e.size; ++i)
        type.inputs.push_back({component_name(e, i), role(e), m.state_index(id) + i});
      equation.operands.push_back(it->second);
      type.fingerprint += "ukf"[static_cast<int>(role(e))] + std::to_string(it->second) + ' ';
    }
    type.fingerprint.back() = ')';
    type.constants.insert(type.constants.end(), c.constants.begin(), c.constants.end());
    type.equations.push_back(std::move(equation));
    type.row_names.resize(type.rows, local_name(c.name));
  }
  return type;
}

}  // namespace desmo
