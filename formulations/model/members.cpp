#include "formulations/model/members.h"

#include <set>
#include <span>

#include "formulations/base/index_range.h"

namespace desmo {

namespace {

/// Returns the positions of numbers among ascending ones; leaves out numbers that are not there.
std::vector<int> positions_in(std::span<const int> ascending, std::span<const int> numbers) {
  std::vector<int> result;
  for (const int number : numbers)
    if (const int position = position_in(ascending, number); position >= 0)
      result.push_back(position);
  return result;
}

}  // namespace

std::vector<GroupId> groups_of(const Model& whole, const Members& members) {
  std::set<GroupId> groups;
  for (const EntityId e : members.entities)
    if (!whole.entities[e].fixed) groups.insert(whole.entities[e].group);
  for (const int c : members.constraints) groups.insert(whole.constraints[c].group);
  return {groups.begin(), groups.end()};
}

Model model_of(const Model& whole, const Members& members) {
  Model m;
  m.name = whole.name;
  m.length_unit = whole.length_unit;
  m.modelling = whole.modelling;
  const std::vector<GroupId> groups = groups_of(whole, members);
  for (const GroupId g : groups) {
    const Group& group = whole.groups[g];
    Group& made = m.groups[m.add_group(group.name, group.bodies)];
    made.constant = group.constant;
    made.after = positions_in(groups, group.after);
    made.entities = positions_in(members.entities, group.entities);
  }
  for (const EntityId id : members.entities) {
    const Entity& e = whole.entities[id];
    const std::vector<double>& values = e.fixed ? whole.fixed_values : whole.estimate;
    const std::span<const double> own(values.data() + e.first, e.size);
    if (e.fixed)
      m.add_fixed(e.kind, e.name, own, std::span(whole.fixed_remainders).subspan(e.first, e.size));
    else
      m.add(e.kind, e.name, own, position_in(groups, e.group));
    m.entities.back().internal = e.internal;
  }
  for (const int c : members.constraints) {
    Constraint& made = m.constraints.emplace_back(whole.constraints[c]);
    for (EntityId& operand : made.operands) operand = position_in(members.entities, operand);
    made.group = position_in(groups, made.group);
  }
  for (const int d : members.drivers)
    m.drive(position_in(members.entities, whole.drivers[d].coordinate), whole.drivers[d].motion);
  validate(m);
  return m;
}

}  // namespace desmo
