// How partitions cut the unknowns, and where the time of a step goes.
#include <algorithm>
#include <array>

#include "report/read/paper_reader.h"
#include "report/read/time_reader.h"

namespace desmo::report {
namespace {

constexpr std::array phases{"residual", "jacobian",         "factorisation",
                            "solve",    "right_hand_sides", "rest"};

std::array<double, 2> read_range(const JsonNode& node) {
  const std::vector<JsonNode> ends = node.elements();
  if (ends.size() != 2) node.complain("two numbers were expected, smallest and largest");
  const std::array range{ends[0].not_negative(), ends[1].not_negative()};
  if (range[0] > range[1]) node.complain("the smallest exceeds the largest");
  return range;
}

Profile read_profile(const JsonNode& node) {
  Profile profile;
  const JsonNode time = node["time_per_step"], split = time["phases"];
  if (read_clock(time["clock"]) != Clock::wall)
    time["clock"].complain("a profile is measured by \"wall\"");
  for (const char* phase : phases)
    profile.seconds_per_step.emplace_back(phase, split[phase].not_negative());
  for (const auto& [phase, seconds] : split.members())
    if (std::find(phases.begin(), phases.end(), phase) == phases.end())
      profile.seconds_per_step.emplace_back(phase, seconds.not_negative());
  if (const auto range = time.find("total_range")) profile.total_range = read_range(*range);
  return profile;
}

Structure read_structure(const JsonNode& node) {
  Structure structure;
  if (const auto units = node.find("units")) structure.units = units->integer(1);
  const JsonNode parts = node["parts"];
  for (const JsonNode& part : parts.elements()) {
    const PartSizes sizes{part["unknowns"].integer(1), part["count"].integer(1)};
    if (!structure.parts.empty() && structure.parts.back().unknowns <= sizes.unknowns)
      part["unknowns"].complain("the parts do not stand largest first, each size once");
    structure.parts.push_back(sizes);
  }
  if (structure.parts.empty()) parts.complain("a structure needs at least one part");
  return structure;
}

}  // namespace

void read_structures(Record& record, const JsonNode& section) {
  const auto list = section.find("structure");
  if (!list) return;
  for (const JsonNode& node : list->elements()) {
    const StructureKey key{node["case"].name(), node["coordinates"].integer(1),
                           node["partition"].name()};
    if (!record.structure.emplace(key, read_structure(node)).second)
      node.complain("the structure of " + key.case_name + "/" + std::to_string(key.coordinates) +
                    "/" + key.partition + " is given twice");
  }
}

void read_profiles(Record& record, const JsonNode& section) {
  const auto list = section.find("profiles");
  if (!list) return;
  for (const JsonNode& node : list->elements()) {
    const CandidateKey key = read_key(node);
    if (!record.profiles.emplace(key, read_profile(node)).second)
      node.complain(name_of(key) + " is given twice");
  }
}

}  // namespace desmo::report
