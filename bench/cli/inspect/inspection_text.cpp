#include <algorithm>
#include <functional>
#include <map>

#include "bench/cli/inspect/inspection.h"
#include "bench/cli/text.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

/// Sizes of the irreducible blocks: "16 + 6×3 + 5×1".
std::string block_sizes(const std::vector<PartDefinition>& blocks) {
  std::map<std::size_t, int, std::greater<>> times_of_size;
  for (const PartDefinition& b : blocks) ++times_of_size[b.unknowns.size()];
  std::string text;
  for (const auto& [size, times] : times_of_size)
    text += (text.empty() ? "" : " + ") + (times > 1 ? std::to_string(times) + "×" : "") +
            std::to_string(size);
  return text.empty() ? "none" : text;
}

std::string line(const std::string& label, const std::string& text) {
  constexpr std::size_t indent = 18;
  return "    " + label + std::string(indent - 4 - label.size(), ' ') + wrap(text, indent) + "\n";
}

std::string group_text(const Inspection& inspection, GroupId g) {
  const Model& m = inspection.model();
  const Group& group = m.groups[g];
  const InspectedGroup& inspected = inspection.groups[g];
  std::vector<std::string> after;
  if (inspected.on_ground) after.push_back("ground");
  for (const GroupId a : group.after) after.push_back(m.groups[a].name);
  std::string text = "  " + group.name;
  if (!group.constant)
    text += " (" + std::to_string(inspected.moving_bodies) + ", " +
            std::to_string(inspected.drivers.size()) + ")";
  text += "\n" + line(group.bodies.size() == 1 ? "body" : "bodies", enumerate(group.bodies));
  if (!inspected.drivers.empty()) text += line("driven", enumerate(inspected.drivers));
  if (!inspected.couplings.empty()) text += line("couplings", enumerate(inspected.couplings));
  text += line("unknowns", std::to_string(inspected.unknowns.size()));
  if (m.modelling != Modelling::natural && !group.constant)
    text += line("solves for", inspected.solved_for.empty() ? "nothing; all of them are derived"
                                                            : enumerate(inspected.solved_for));
  text += line("blocks", block_sizes(inspected.blocks));
  text += line("entities", enumerate(entity_names(m, group.entities)));
  if (!group.constant) text += line("after", enumerate(after));
  return text;
}

/// The tree, body by body, and the joints that were cut.
std::string tree_text(const Inspection& inspection) {
  std::string text = "\nSpanning tree, parents first:\n";
  for (const auto& [body, parent, joint] : inspection.tree)
    text += "  " + wrap(body + " on " + parent + ": " + (joint.empty() ? "free joint" : joint), 4) +
            "\n";
  text += "Joints that are not of the tree: " + std::to_string(inspection.cut_joints.size()) + "\n";
  for (const std::string& joint : inspection.cut_joints) text += "  " + wrap(joint, 4) + "\n";
  return text;
}

std::string left_out_text(const LeftOut& left_out, const Model& m) {
  const bool in_part = std::ranges::any_of(m.constraints, [&](const Constraint& c) {
    return c.name == left_out.equation && kept_rows(c) > 0;
  });
  std::string what = left_out.equation;
  if (in_part) what += ", " + count(static_cast<long>(left_out.rows.size()), "row") + " of it";
  what += " (" + m.groups[left_out.group].name + "): follows from " +
          (left_out.follows_from.empty() ? "what earlier groups determine"
                                         : enumerate(left_out.follows_from, 12));
  if (left_out.redundant) what += "; redundant but consistent: accepted";
  return "  " + wrap(what, 4) + "\n";
}

}  // namespace

std::string to_text(const Inspection& inspection) {
  const Model& m = inspection.model();
  const int independent = m.degrees_of_freedom();
  std::string text = m.name;
  if (!inspection.title.empty()) text += ": " + printable(inspection.title, 200);
  text += "\n\n" + std::string(inspection.dimension == 2 ? "plane" : "space") + ", " +
          count(inspection.bodies, "moving body", "moving bodies") + ", " +
          count(inspection.joints, "joint") + "\n";
  if (m.modelling != Modelling::natural)
    text += std::string(name_of(m.modelling)) + " coordinates\n";
  text += wrap(count(m.coordinates(), "coordinate") + ": " +
                   std::to_string(m.coordinates() - independent) + " dependent, " +
                   std::to_string(independent) + " independent (" + enumerate(driver_names(m), 24) +
                   ")",
               2) +
          "\n";

  text += "\nStructural groups in solution order, each with (moving bodies, driven coordinates): " +
          std::to_string(m.structural_groups()) + "\n";
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g)
    if (!m.groups[g].constant) text += group_text(inspection, g);
  text += "\nConstant parts, solved once: " + std::to_string(inspection.constant_parts()) + "\n";
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g)
    if (m.groups[g].constant) text += group_text(inspection, g);

  if (!inspection.tree.empty()) text += tree_text(inspection);
  text += "\nConstraints left out, because they follow from others: " +
          std::to_string(inspection.modelled.left_out.size()) + "\n";
  for (const LeftOut& l : inspection.modelled.left_out) text += left_out_text(l, m);

  if (inspection.modelled.idle.empty()) return text;
  text += "\nIdle freedoms, which move nothing that is modelled: " +
          std::to_string(inspection.modelled.idle.size()) + "\n";
  for (const IdleFreedom& f : inspection.modelled.idle)
    text += "  " + wrap(f.body + ": free to spin about " + f.about, 4) + "\n";
  return text;
}

}  // namespace desmo::cli
