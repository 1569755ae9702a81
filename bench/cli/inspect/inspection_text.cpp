#include "bench/cli/inspect/inspection_text.h"

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/cli/text.h"
#include "bench/cli/units.h"
#include "cases/mechanism/names.h"
#include "formulations/base/settings.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

bool is_natural(const Json& structure) {
  return structure["coordinates"]["kind"] == name_of(Modelling::natural);
}

/// Returns the numbers of unknowns of the irreducible blocks: "16 + 6×3" for one block of 16
/// unknowns and six of 3; "none" without blocks.
std::string block_sizes(const Json& blocks) {
  std::map<std::size_t, int, std::greater<>> times_of_size;
  for (const Json& b : blocks) ++times_of_size[b["unknowns"].size()];
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

std::string group_text(const Json& group, bool has_derived) {
  const bool constant = group["constant"];
  const Json &driven = group["driven"], &couplings = group["couplings"];
  std::string text = "  " + group["name"].get<std::string>();
  if (!constant)
    text += " (" + group["moving_bodies"].dump() + ", " + std::to_string(driven.size()) + ")";
  text += "\n" + line(group["bodies"].size() == 1 ? "body" : "bodies", enumerate(group["bodies"]));
  if (!driven.empty()) text += line("driven", enumerate(driven));
  if (!couplings.empty()) text += line("couplings", enumerate(couplings));
  text += line("unknowns", group["unknowns"].dump());
  if (has_derived && !constant)
    text += line("solves for", group["solves_for"].empty() ? "nothing; all of them are derived"
                                                           : enumerate(group["solves_for"]));
  text += line("blocks", block_sizes(group["blocks"]));
  text += line("entities", enumerate(group["entities"]));
  if (constant) return text;
  std::vector<std::string> after = group["after"];
  if (group["on_ground"]) after.insert(after.begin(), "ground");
  return text + line("after", enumerate(after));
}

/// Returns a heading with the number of entries, followed by the entries.
std::string section(const std::string& heading, const std::vector<std::string>& entries) {
  std::string text = heading + ": " + std::to_string(entries.size()) + "\n";
  for (const std::string& entry : entries) text += entry;
  return text;
}

std::string entry(const std::string& text) { return "  " + wrap(text, 4) + "\n"; }

std::string groups_text(const std::string& heading, const Json& structure, bool constant) {
  std::vector<std::string> entries;
  for (const Json& group : structure["groups"])
    if (group["constant"] == constant) entries.push_back(group_text(group, !is_natural(structure)));
  return section("\n" + heading, entries);
}

/// Returns the spanning tree, body by body, and the joints that were cut.
std::string tree_text(const Json& structure) {
  std::string text = "\nSpanning tree, parents first:\n";
  for (const Json& hanging : structure["tree"]) {
    const std::string body = hanging["body"], parent = hanging["parent"], joint = hanging["joint"];
    text += entry(body + " on " + parent + ": " + (joint.empty() ? "free joint" : joint));
  }
  std::vector<std::string> cut;
  for (const Json& joint : structure["cut_joints"]) cut.push_back(entry(joint));
  return text + section("Joints that are not of the tree", cut);
}

/// Returns whether only some rows of an equation are left out, so that others are kept.
bool is_kept_in_part(const Json& left_out, const Json& groups) {
  for (const Json& group : groups)
    if (group["name"] == left_out["group"])
      for (const Json& block : group["blocks"])
        for (const Json& kept : block["equations"])
          if (kept["name"] == left_out["equation"]) return true;
  return false;
}

std::string left_out_text(const Json& left_out, const Json& groups) {
  std::string what = left_out["equation"];
  if (is_kept_in_part(left_out, groups))
    what += ", " + count(left_out["rows"].size(), "row") + " of it";
  what += " (" + left_out["group"].get<std::string>() + "): ";
  if (const Json& misfit = left_out["misfit"]; !misfit.is_null()) {
    const DisplayUnit unit{misfit["unit"]};
    what += "between points of the ground; off by " + quantity(misfit["amount"], unit, "%.1e");
  } else {
    what += "follows from " + (left_out["follows_from"].empty()
                                   ? "what earlier groups determine"
                                   : enumerate(left_out["follows_from"], 12));
  }
  if (left_out["redundant"]) what += "; redundant but consistent: accepted";
  return entry(what);
}

}  // namespace

std::string inspection_text(const Json& structure) {
  const Json& coordinates = structure["coordinates"];
  const std::vector<std::string> independent = coordinates["independent"];
  const std::string title = structure["title"], kind = coordinates["kind"];
  std::string text = structure["name"];
  if (!title.empty()) text += ": " + printable(title, 200);
  text += std::string("\n\n") + (structure["dimension"] == 2 ? "plane" : "space") + ", " +
          count(structure["bodies"], "moving body", "moving bodies") + ", " +
          count(structure["joints"], "joint") + "\n";
  if (!is_natural(structure)) text += kind + " coordinates\n";
  text += wrap(count(coordinates["all"], "coordinate") + ": " + coordinates["dependent"].dump() +
                   " dependent, " + std::to_string(independent.size()) + " independent (" +
                   enumerate(independent, 24) + ")",
               2) +
          "\n";
  text += groups_text(
      "Structural groups in solution order, each with (moving bodies, driven coordinates)",
      structure, false);
  text += groups_text("Constant parts, solved once", structure, true);
  if (!structure["tree"].empty()) text += tree_text(structure);

  std::vector<std::string> left_out, idle;
  for (const Json& l : structure["left_out"])
    left_out.push_back(left_out_text(l, structure["groups"]));
  text += section("\nConstraints left out, because they follow from others or are of the ground",
                  left_out);
  for (const Json& f : structure["idle_freedoms"])
    idle.push_back(entry(f["body"].get<std::string>() + ": free to spin about " +
                         f["about"].get<std::string>()));
  if (!idle.empty()) text += section("\nIdle freedoms, which move nothing that is modelled", idle);
  return text;
}

}  // namespace desmo::cli
