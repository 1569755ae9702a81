// desmo inspect: the structure of a mechanism. It is collected in one JSON document, from which
// both output formats are written.
#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/cli/commands.h"
#include "bench/cli/drawing_notes.h"
#include "bench/cli/errors.h"
#include "bench/cli/input.h"
#include "bench/cli/inspect/inspection_text.h"
#include "bench/cli/text.h"
#include "cases/io/new_files.h"
#include "formulations/model/partition.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr GroupId ground = -1;

/// Returns the groups with the names that the model lists; counts and other lists come later.
Json list_groups(const Model& m) {
  Json groups = Json::array();
  for (const Group& group : m.groups)
    groups.push_back({{"name", group.name},
                      {"constant", group.constant},
                      {"bodies", group.bodies},
                      {"moving_bodies", 0},  // N_m of the paper; rigidly joined ones count as one
                      {"driven", Json::array()},     // n_c of the paper: coordinates driven in it
                      {"couplings", Json::array()},  // couplings whose equations it contains
                      {"unknowns", 0},
                      {"solves_for", Json::array()},  // entities neither derived, driven nor fixed
                      {"entities", names_at(m.entities, group.entities)},
                      {"on_ground", false},
                      {"joined_to", Json::array()},  // earlier groups that a joint connects it with
                      {"after", names_at(m.groups, group.after)},
                      {"blocks", Json::array()}});  // irreducible blocks, in solution order
  return groups;
}

void increase(Json& number, std::size_t by) { number = number.get<std::size_t>() + by; }

void add_entities(const Model& m, Json& groups) {
  std::vector<bool> known(m.entities.size(), false);  // by entity: it is derived or driven
  for (const Driver& driver : m.drivers) {
    const Entity& driven = m.entities[driver.coordinate];
    groups[driven.group]["driven"].push_back(driven.name);
    known[driver.coordinate] = true;
  }
  for (const Constraint& c : m.constraints) {
    if (constraint_kind_name(c.kind).starts_with("coupling"))
      groups[c.group]["couplings"].push_back(c.name.substr(0, c.name.rfind(':')));
    if (c.derives >= 0) known[derived_entity(c)] = true;
  }
  for (std::size_t e = 0; e < m.entities.size(); ++e)
    if (!known[e] && !m.entities[e].fixed)
      groups[m.entities[e].group]["solves_for"].push_back(m.entities[e].name);
}

/// Returns the constraints that the equations belong to. Each has the list of its rows that are
/// among the equations.
Json equations_json(const Model& m, const std::vector<Equation>& equations) {
  Json list = Json::array();
  for (std::size_t i = 0; i < equations.size(); ++i) {
    if (i == 0 || equations[i - 1].constraint != equations[i].constraint)
      list.push_back(
          {{"name", m.constraints[equations[i].constraint].name}, {"rows", Json::array()}});
    list.back()["rows"].push_back(equations[i].row);
  }
  return list;
}

void add_blocks(const Model& m, Json& groups) {
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (const PartDefinition& block : make_partition(m, Partition::block)) {
    Json& group = groups[block.groups.front()];
    Json unknowns = Json::array();
    for (const int i : block.unknowns) unknowns.push_back(coordinate_name(m, owner[i], i));
    group["blocks"].push_back(
        {{"unknowns", unknowns}, {"equations", equations_json(m, block.equations)}});
    increase(group["unknowns"], unknowns.size());
  }
}

/// Returns the group of each rigid body, `ground` for the first.
std::vector<GroupId> group_of_rigid_bodies(const Model& m, const Mechanism& mechanism,
                                           const RigidBodies& rigid) {
  std::map<std::string, GroupId> by_name;
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g)
    if (!m.groups[g].constant)
      for (const std::string& body : m.groups[g].bodies) by_name[body] = g;
  std::vector<GroupId> groups(rigid.list.size(), ground);
  for (std::size_t r = 1; r < groups.size(); ++r)
    groups[r] = by_name.at(mechanism.bodies[rigid.list[r].bodies.front()].name);
  return groups;
}

void add_neighbours(const Model& m, const Mechanism& mechanism, const RigidBodies& rigid,
                    Json& groups) {
  const std::vector<GroupId> group = group_of_rigid_bodies(m, mechanism, rigid);
  for (std::size_t r = 1; r < group.size(); ++r) increase(groups[group[r]]["moving_bodies"], 1);
  std::set<std::pair<GroupId, GroupId>> joined;  // (group, an earlier one that it is joined to)
  for (const Mechanism::Joint& joint : mechanism.joints) {
    const auto [first, last] =
        std::minmax(group[rigid.of_body[joint.bodies[0]]], group[rigid.of_body[joint.bodies[1]]]);
    if (first == last) continue;
    if (first == ground)
      groups[last]["on_ground"] = true;
    else
      joined.emplace(last, first);
  }
  for (const auto& [g, earlier] : joined) groups[g]["joined_to"].push_back(m.groups[earlier].name);
}

/// Returns the spanning tree of a model with frames, parents first, and the joints that are cut;
/// two empty arrays for a model without frames.
std::pair<Json, Json> describe_tree(const Model& m, const Mechanism& mechanism,
                                    const RigidBodies& rigid) {
  Json bodies = Json::array(), cut_joints = Json::array();
  if (!has_frames(m.modelling)) return {bodies, cut_joints};
  const SpanningTree tree =
      make_tree(mechanism, rigid, find_structure(mechanism, rigid), m.modelling);
  const auto name = [&](int r) { return mechanism.bodies[rigid.list[r].bodies.front()].name; };
  for (const int r : tree.order)
    if (const TreeJoint& hanging = tree.hanging[r]; tree.has_frame[r])
      bodies.push_back({{"body", name(r)},
                        {"parent", name(hanging.parent)},
                        {"joint", hanging.joint < 0 ? "" : mechanism.joints[hanging.joint].name}});
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j)
    if (rigid.of_body[mechanism.joints[j].bodies[0]] !=
            rigid.of_body[mechanism.joints[j].bodies[1]] &&
        !tree.is_of_tree[j])
      cut_joints.push_back(mechanism.joints[j].name);
  return {bodies, cut_joints};
}

/// Returns by how much an equation does not hold, in the units of the input; null where its misfit
/// was not computed.
Json describe_misfit(const LeftOut& left_out, const DisplayUnits& units) {
  if (!left_out.misfit) return nullptr;
  const DisplayUnit unit = left_out.misfit->unit(units);
  return {{"amount", unit.from_si(left_out.misfit->amount)}, {"unit", unit.name}};
}

/// Returns the structure of an input and its model; the keys are those of `desmo inspect --json`.
/// Throws InputError.
Json inspect(const Input& input, const ModellingResult& modelled) {
  const Mechanism& mechanism = input.scene.mechanism;
  const Model& m = modelled.model;
  const RigidBodies rigid = find_rigid_bodies(mechanism);
  Json groups = list_groups(m);
  add_entities(m, groups);
  try {
    add_blocks(m, groups);
  } catch (const std::invalid_argument& error) {
    throw InputError(input.source + ": " + error.what());
  }
  add_neighbours(m, mechanism, rigid, groups);
  const auto [tree, cut_joints] = describe_tree(m, mechanism, rigid);
  Json left_out = Json::array();
  for (const LeftOut& l : modelled.left_out)
    left_out.push_back({{"equation", l.equation},
                        {"rows", l.rows},
                        {"group", m.groups[l.group].name},
                        {"follows_from", l.follows_from},
                        {"redundant", l.redundant},
                        {"misfit", describe_misfit(l, input.units)}});
  Json idle = Json::array();
  for (const IdleFreedom& f : modelled.idle) idle.push_back({{"body", f.body}, {"about", f.about}});
  return {{"name", m.name},
          {"title", mechanism.title},
          {"dimension", mechanism.dimension},
          {"length_unit", m.length_unit},
          {"bodies", mechanism.bodies.size() - 1},  // without the ground
          {"joints", mechanism.joints.size()},
          {"coordinates",
           {{"kind", name_of(m.modelling)},
            {"all", m.coordinates()},
            {"dependent", m.coordinates() - m.degrees_of_freedom()},
            {"independent", driver_names(m)}}},
          {"constant_parts", std::ranges::count(m.groups, true, &Group::constant)},
          {"groups", std::move(groups)},
          {"tree", tree},
          {"cut_joints", cut_joints},
          {"left_out", left_out},
          {"idle_freedoms", idle}};
}

struct InspectOptions {
  std::string mechanism;
  bool json = false;
  Modelling coordinates = Modelling::natural;
};

void run(const InspectOptions& options) {
  const Input input = load_mechanism(options.mechanism);
  const ModellingResult modelled = model_mechanism(input, options.coordinates);
  const Json structure = inspect(input, modelled);
  if (options.coordinates == Modelling::natural)
    std::fputs(note_on_drawing(input.scene.mechanism, modelled.model, input.units).c_str(), stderr);
  write_standard_output(options.json ? structure.dump(1) + "\n" : inspection_text(structure));
}

}  // namespace

void add_inspect(CLI::App& program) {
  const auto [command, options] = add_command(
      program, "inspect", "Structural groups, coordinates and equations of a mechanism", run);
  command
      .add_option("mechanism", options.mechanism,
                  "Mechanism or scene file, - for standard input, library mechanism, or scalable "
                  "case with its units, such as truck_suspension:5")
      ->required();
  Choices<Modelling> kinds;
  for (const Modelling kind : modelling_kinds) kinds.emplace_back(name_of(kind), kind);
  add_choice(command, "--coordinates", options.coordinates, kinds,
             "natural (default), basis, reference or relative: the tree, its variables, the joints "
             "that are cut, and what each group solves for");
  command.add_flag("--json", options.json, "As JSON, with equations and unknowns by name");
  command.footer(
      "Examples:\n"
      "  desmo inspect slider_crank\n"
      "  desmo inspect mine.json --json\n"
      "  desmo inspect truck_suspension:1 --coordinates relative");
}

}  // namespace desmo::cli
