#include <nlohmann/json.hpp>

#include "bench/cli/inspect/inspection.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

Json names_of_groups(const Model& m, const std::vector<GroupId>& groups) {
  Json names = Json::array();
  for (const GroupId g : groups) names.push_back(m.groups[g].name);
  return names;
}

/// Each constraint with the rows that are equations.
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

Json blocks_json(const Model& m, const std::vector<EntityId>& owner,
                 const std::vector<PartDefinition>& blocks) {
  Json list = Json::array();
  for (const PartDefinition& block : blocks) {
    Json unknowns = Json::array();
    for (const int i : block.unknowns) unknowns.push_back(coordinate_name(m, owner[i], i));
    list.push_back({{"unknowns", unknowns}, {"equations", equations_json(m, block.equations)}});
  }
  return list;
}

Json groups_json(const Inspection& inspection) {
  const Model& m = inspection.model();
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  Json list = Json::array();
  for (std::size_t g = 0; g < m.groups.size(); ++g) {
    const Group& group = m.groups[g];
    const InspectedGroup& inspected = inspection.groups[g];
    list.push_back({{"name", group.name},
                    {"constant", group.constant},
                    {"bodies", group.bodies},
                    {"moving_bodies", inspected.moving_bodies},
                    {"driven", inspected.drivers},
                    {"couplings", inspected.couplings},
                    {"unknowns", inspected.unknowns.size()},
                    {"solves_for", inspected.solved_for},
                    {"entities", entity_names(m, group.entities)},
                    {"on_ground", inspected.on_ground},
                    {"joined_to", names_of_groups(m, inspected.joined_to)},
                    {"after", names_of_groups(m, group.after)},
                    {"blocks", blocks_json(m, owner, inspected.blocks)}});
  }
  return list;
}

}  // namespace

std::string to_json(const Inspection& inspection) {
  const Model& m = inspection.model();
  Json left_out = Json::array();
  for (const LeftOut& l : inspection.modelled.left_out)
    left_out.push_back({{"equation", l.equation},
                        {"rows", l.rows},
                        {"group", m.groups[l.group].name},
                        {"follows_from", l.follows_from},
                        {"redundant", l.redundant}});
  Json idle = Json::array();
  for (const IdleFreedom& f : inspection.modelled.idle)
    idle.push_back({{"body", f.body}, {"about", f.about}});
  Json tree = Json::array();
  for (const auto& [body, parent, joint] : inspection.tree)
    tree.push_back({{"body", body}, {"parent", parent}, {"joint", joint}});
  const Json all = {{"name", m.name},
                    {"title", inspection.title},
                    {"dimension", inspection.dimension},
                    {"length_unit", m.length_unit},
                    {"bodies", inspection.bodies},
                    {"joints", inspection.joints},
                    {"coordinates",
                     {{"kind", name_of(m.modelling)},
                      {"all", m.coordinates()},
                      {"dependent", m.coordinates() - m.degrees_of_freedom()},
                      {"independent", driver_names(m)}}},
                    {"constant_parts", inspection.constant_parts()},
                    {"groups", groups_json(inspection)},
                    {"tree", tree},
                    {"cut_joints", inspection.cut_joints},
                    {"left_out", left_out},
                    {"idle_freedoms", idle}};
  return all.dump(1) + "\n";
}

}  // namespace desmo::cli
