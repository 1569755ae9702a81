#include "bench/cli/inspect/inspection.h"

#include <algorithm>
#include <map>
#include <set>

#include "bench/cli/errors.h"
#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo::cli {
namespace {

constexpr GroupId ground = -1;

/// The group of each rigid body.
std::vector<GroupId> group_of_rigid_bodies(const Model& m, const Mechanism& d,
                                           const RigidBodies& rigid) {
  std::map<std::string, GroupId> by_name;
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g)
    if (!m.groups[g].constant)
      for (const std::string& body : m.groups[g].bodies) by_name[body] = g;
  std::vector<GroupId> groups(rigid.list.size(), ground);
  for (std::size_t r = 1; r < groups.size(); ++r)
    groups[r] = by_name.at(d.bodies[rigid.list[r].bodies.front()].name);
  return groups;
}

void find_neighbours(const Mechanism& d, Inspection& result) {
  const RigidBodies rigid = find_rigid_bodies(d);
  const std::vector<GroupId> group = group_of_rigid_bodies(result.model(), d, rigid);
  for (std::size_t r = 1; r < group.size(); ++r) ++result.groups[group[r]].moving_bodies;
  std::vector<std::set<GroupId>> joined(result.groups.size());
  for (const Mechanism::Joint& joint : d.joints) {
    const auto [first, last] =
        std::minmax(group[rigid.of_body[joint.bodies[0]]], group[rigid.of_body[joint.bodies[1]]]);
    if (first == last) continue;
    if (first == ground)
      result.groups[last].on_ground = true;
    else
      joined[last].insert(first);
  }
  for (std::size_t g = 0; g < joined.size(); ++g)
    result.groups[g].joined_to.assign(joined[g].begin(), joined[g].end());
}

}  // namespace

int Inspection::constant_parts() const {
  return static_cast<int>(std::ranges::count(model().groups, true, &Group::constant));
}

Inspection inspect(const Input& input) {
  const Mechanism& d = input.scene.mechanism;
  Inspection result{d.title,
                    d.dimension,
                    static_cast<int>(d.bodies.size()) - 1,
                    static_cast<int>(d.joints.size()),
                    model_mechanism(input),
                    {}};
  const Model& m = result.model();
  result.groups.resize(m.groups.size());
  for (const Driver& driver : m.drivers)
    result.groups[m.entities[driver.coordinate].group].drivers.push_back(
        m.entities[driver.coordinate].name);
  for (const Constraint& c : m.constraints)
    if (constraint_kind_name(c.kind).starts_with("coupling"))
      result.groups[c.group].couplings.push_back(c.name.substr(0, c.name.rfind(':')));
  try {
    for (PartDefinition& block : make_partition(m, Partition::block)) {
      InspectedGroup& group = result.groups[block.groups.front()];
      group.unknowns.insert(group.unknowns.end(), block.unknowns.begin(), block.unknowns.end());
      group.blocks.push_back(std::move(block));
    }
  } catch (const std::invalid_argument& error) {
    throw InputError(input.source + ": " + error.what());
  }
  find_neighbours(d, result);
  return result;
}

std::vector<std::string> entity_names(const Model& m, const std::vector<EntityId>& entities) {
  std::vector<std::string> names;
  for (const EntityId e : entities) names.push_back(m.entities[e].name);
  return names;
}

std::vector<std::string> driver_names(const Model& m) {
  std::vector<std::string> names;
  for (const Driver& d : m.drivers) names.push_back(m.entities[d.coordinate].name);
  return names;
}

}  // namespace desmo::cli
