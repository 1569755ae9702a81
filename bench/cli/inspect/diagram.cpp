#include <algorithm>

#include "bench/cli/inspect/inspection.h"

namespace desmo::cli {
namespace {

/// A string of the DOT language; line feeds are kept.
std::string dot_string(const std::string& text) {
  std::string escaped = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return escaped + "\"";
}

std::string node(GroupId g) { return "g" + std::to_string(g); }

/// (N_m, n_c), the group, and its bodies a few on each line, without what their names have in
/// common with the group's.
std::string label(const InspectedGroup& inspected, const Group& group) {
  constexpr std::size_t on_a_line = 4;
  const std::size_t prefix = group.name.rfind('/') + 1;  // 0 when there is none
  std::string text = "(" + std::to_string(inspected.moving_bodies) + ", " +
                     std::to_string(inspected.drivers.size()) + ")\n" + group.name + "\n{";
  for (std::size_t b = 0; b < group.bodies.size(); ++b)
    text += (b == 0 ? "" : b % on_a_line == 0 ? ",\n" : ", ") + group.bodies[b].substr(prefix);
  return text + "}";
}

std::string arrow(const std::string& from, const std::string& to, const char* style = "") {
  return "  " + from + " -> " + to + style + ";\n";
}

std::string arrows_to(const Inspection& inspection, GroupId g) {
  const InspectedGroup& group = inspection.groups[g];
  std::string text;
  if (group.on_ground) text += arrow("ground", node(g));
  for (const GroupId a : group.joined_to) text += arrow(node(a), node(g));
  for (const GroupId a : inspection.model().groups[g].after)
    if (std::ranges::find(group.joined_to, a) == group.joined_to.end())
      text += arrow(node(a), node(g), " [style=dashed]");
  return text;
}

}  // namespace

std::string to_dot(const Inspection& inspection) {
  const Model& m = inspection.model();
  std::string nodes, arrows;
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g) {
    if (m.groups[g].constant) continue;
    nodes +=
        "  " + node(g) + " [label=" + dot_string(label(inspection.groups[g], m.groups[g])) + "];\n";
    arrows += arrows_to(inspection, g);
  }
  return "digraph " + dot_string(m.name) +
         " {\n"
         "  rankdir=LR;\n"
         "  node [shape=circle, margin=0.02, fontname=\"Helvetica\", fontsize=11];\n"
         "  ground [label=\"0\"];\n" +
         nodes + arrows + "}\n";
}

}  // namespace desmo::cli
