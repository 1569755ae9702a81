#include <algorithm>

#include "bench/cli/inspection.h"
#include "bench/cli/text.h"

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

/// Group, and its bodies a few on each line.
std::string legend(const Group& group) {
  constexpr std::size_t on_a_line = 4;
  std::string text = group.name;
  for (std::size_t b = 0; b < group.bodies.size(); ++b)
    text += (b % on_a_line == 0 ? (b == 0 ? "\n" : ",\n") : ", ") + group.bodies[b];
  return text;
}

std::string arrow(const std::string& from, const std::string& to, const char* style = "") {
  return "  " + from + " -> " + to + style + ";\n";
}

std::string arrows_to(const Inspection& inspection, GroupId g) {
  const InspectedGroup& group = inspection.groups[g];
  std::string text;
  if (group.on_ground) text += arrow("ground", node(g));
  for (const GroupId a : group.joined_to) text += arrow(node(a), node(g));
  for (const GroupId a : inspection.mechanism().groups[g].after)
    if (std::ranges::find(group.joined_to, a) == group.joined_to.end())
      text += arrow(node(a), node(g), " [style=dashed]");
  return text;
}

}  // namespace

std::string to_dot(const Inspection& inspection) {
  const Mechanism& m = inspection.mechanism();
  std::string nodes, arrows;
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g) {
    if (m.groups[g].constant) continue;
    const InspectedGroup& group = inspection.groups[g];
    nodes += "  " + node(g) + " [label=\"(" + std::to_string(group.moving_bodies) + ", " +
             std::to_string(group.drivers.size()) +
             ")\", xlabel=" + dot_string(legend(m.groups[g])) + "];\n";
    arrows += arrows_to(inspection, g);
  }
  return "digraph " + dot_string(m.name) +
         " {\n"
         "  rankdir=LR;\n"
         "  nodesep=0.8;\n"
         "  ranksep=1;\n"
         "  forcelabels=true;\n"
         "  node [shape=circle, fixedsize=true, width=0.8, fontname=\"Helvetica\", fontsize=12];\n"
         "  ground [label=\"0\"];\n" +
         nodes + arrows + "}\n";
}

}  // namespace desmo::cli
