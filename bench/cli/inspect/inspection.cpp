#include "bench/cli/inspect/inspection.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "bench/cli/errors.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/frames/tree.h"

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

void list_solved_for(Inspection& result) {
  const Model& m = result.model();
  std::vector<bool> known(m.entities.size(), false);  // derived or driven
  for (const Constraint& c : m.constraints)
    if (c.derives >= 0) known[derived_entity(c)] = true;
  for (const Driver& driver : m.drivers) known[driver.coordinate] = true;
  for (std::size_t e = 0; e < m.entities.size(); ++e)
    if (!known[e] && !m.entities[e].fixed)
      result.groups[m.entities[e].group].solved_for.push_back(m.entities[e].name);
}

void describe_tree(const Mechanism& d, Modelling modelling, Inspection& result) {
  const RigidBodies rigid = find_rigid_bodies(d);
  const SpanningTree tree = make_tree(d, rigid, find_structure(d, rigid), modelling);
  const auto name = [&](int r) { return d.bodies[rigid.list[r].bodies.front()].name; };
  for (const int r : tree.order)
    if (const TreeJoint& hanging = tree.hanging[r]; tree.has_frame[r])
      result.tree.push_back(
          {name(r), name(hanging.parent), hanging.joint < 0 ? "" : d.joints[hanging.joint].name});
  for (std::size_t j = 0; j < d.joints.size(); ++j)
    if (rigid.of_body[d.joints[j].bodies[0]] != rigid.of_body[d.joints[j].bodies[1]] &&
        !tree.is_of_tree[j])
      result.cut_joints.push_back(d.joints[j].name);
}

}  // namespace

int Inspection::constant_parts() const {
  return static_cast<int>(std::ranges::count(model().groups, true, &Group::constant));
}

Inspection inspect(const Input& input, Modelling modelling) {
  const Mechanism& d = input.scene.mechanism;
  Inspection result{d.title,
                    d.dimension,
                    static_cast<int>(d.bodies.size()) - 1,
                    static_cast<int>(d.joints.size()),
                    model_mechanism(input, modelling),
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
  list_solved_for(result);
  if (has_frames(modelling)) describe_tree(d, modelling, result);
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
