#include "formulations/model/part_type.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

#include "formulations/constraints/kinds.h"

namespace desmo {

namespace {

std::string local_name(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  return slash == std::string::npos ? name : name.substr(slash + 1);
}

}  // namespace

PartType describe_type(const Model& m, const PartDefinition& part) {
  const auto role = [&](const Entity& e, int component) {
    if (!e.fixed && std::ranges::binary_search(part.unknowns, e.first + component))
      return Role::unknown;
    return e.fixed || m.groups[e.group].constant ? Role::fixed : Role::known;
  };

  PartType type;
  std::map<EntityId, int> first_input;
  for (std::size_t i = 0; i < part.equations.size();) {
    const int position = part.equations[i].constraint;
    const Constraint& c = m.constraints[position];
    const KindDescription& kind = description_of(c.kind);
    PartType::Constraint own{c.kind, {}, static_cast<int>(type.constants.size()), {}};
    for (; i < part.equations.size() && part.equations[i].constraint == position; ++i) {
      own.rows.push_back(part.equations[i].row);
      type.row_names.push_back(local_name(c.name));
    }
    type.fingerprint += kind.name;
    if (static_cast<int>(own.rows.size()) < kind.rows)
      for (const int row : own.rows) type.fingerprint += "." + std::to_string(row);
    type.fingerprint += '(';
    for (const EntityId id : c.operands) {
      const Entity& e = m.entities[id];
      const auto [it, is_new] = first_input.try_emplace(id, static_cast<int>(type.inputs.size()));
      for (int k = 0; k < e.size; ++k) {
        if (is_new)
          type.inputs.push_back(
              {local_name(coordinate_name(m, id, e.first + k)), role(e, k), m.state_index(id) + k});
        type.fingerprint += "ukf"[static_cast<int>(role(e, k))];
      }
      own.operands.push_back(it->second);
      type.fingerprint += std::to_string(it->second) + ' ';
    }
    // A right angle, or no offset, makes simpler code: which dimensions are zero belongs to the
    // type.
    std::size_t dimensions = c.constants.size();
    if (kind.table >= 0) {
      type.fingerprint += 't' + std::to_string(dimensions - kind.table) + ' ';
      dimensions = kind.table;
    }
    for (std::size_t k = 0; k < dimensions; ++k)
      if (c.constants[k].value == 0) type.fingerprint += 'c' + std::to_string(k) + "=0 ";
    type.fingerprint.back() = ')';
    std::ranges::transform(c.constants, std::back_inserter(type.constants), &Derived::value);
    type.constraints.push_back(std::move(own));
  }
  return type;
}

std::vector<int> gather_types(const Model& m, std::vector<PartDefinition>& parts) {
  // Depth: length of the longest sequence of parts that must be solved before. Types are numbered
  // by first appearance.
  std::vector<int> depth_of_coordinate(m.coordinates(), -1);
  std::map<std::string, int> number_of_type;
  std::vector<std::tuple<bool, int, int>> rank;
  for (const PartDefinition& part : parts) {
    const PartType type = describe_type(m, part);
    int depth = 0;
    for (const PartType::Input& input : type.inputs)
      if (input.role == Role::known) depth = std::max(depth, depth_of_coordinate[input.state] + 1);
    for (const int i : part.unknowns) depth_of_coordinate[i] = depth;
    const int number = static_cast<int>(number_of_type.size());
    rank.emplace_back(!part.constant, depth,
                      number_of_type.try_emplace(type.fingerprint, number).first->second);
  }
  std::vector<int> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return rank[i]; });
  std::vector<PartDefinition> sorted;
  std::vector<int> type_ends;
  for (std::size_t k = 0; k < order.size(); ++k) {
    sorted.push_back(std::move(parts[order[k]]));
    if (k + 1 == order.size() || rank[order[k]] != rank[order[k + 1]])
      type_ends.push_back(static_cast<int>(k) + 1);
  }
  parts = std::move(sorted);
  return type_ends;
}

}  // namespace desmo
