// What the structure of the equations knows beyond that of the bodies.
#include <array>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr std::array partition_names{"global", "group", "block"};

/// Sums something over all parts.
template <class Of>
double total(const Structure& structure, Of of) {
  double sum = 0;
  for (const auto& [unknowns, count] : structure.parts)
    sum += static_cast<double>(count) * of(static_cast<double>(unknowns));
  return sum;
}

std::int64_t parts_of(const Structure& structure) {
  return static_cast<std::int64_t>(total(structure, [](double) { return 1.0; }));
}

/// "16 + 2×4 + 20×3"
std::string addends(const Structure& structure) {
  std::string text;
  for (const auto& [unknowns, count] : structure.parts)
    text += (text.empty() ? "" : " + ") + (count > 1 ? std::to_string(count) + "×" : "") +
            std::to_string(unknowns);
  return text;
}

std::string what_equations_add(const StructureKey& key, const Structure& group,
                               const Structure& block) {
  const auto work = [](double n) { return n * n * n; };  // of dense elimination
  const PartSizes& smallest = block.parts.back();
  return sentence(
      parts_of(group) == parts_of(block) ? "partitions.same" : "partitions.more",
      {{"case", key.case_name},
       {"coordinates", key.coordinates},
       {"groups", parts_of(group)},
       {"largest_group", group.parts.front().unknowns},
       {"blocks", parts_of(block)},
       {"largest_block", block.parts.front().unknowns},
       {"alone", smallest.unknowns == 1 ? smallest.count : 0},
       {"unknowns", static_cast<std::int64_t>(total(block, [](double n) { return n; }))},
       {"share", write_significant(100 * total(block, work) / total(group, work), 2)}});
}

}  // namespace

Section partitions(const Record& record) {
  Section section = headed_section("partitions");
  Table table = headed_table("partition_sizes");
  std::map<std::string, StructureKey> largest;  // of each case
  for (auto at = record.structure.begin(); at != record.structure.end();
       at = record.structure.upper_bound({at->first.case_name, at->first.coordinates, "~"})) {
    StructureKey key = at->first;
    largest[key.case_name] = key;
    for (const char* name : partition_names) {
      key.partition = name;
      const auto found = record.structure.find(key);
      if (found == record.structure.end()) continue;
      const Structure& structure = found->second;
      table.rows.push_back(
          {key.case_name, key.coordinates, name, digits_entry(std::to_string(parts_of(structure))),
           digits_entry(std::to_string(structure.parts.front().unknowns)), addends(structure)});
    }
  }
  for (const auto& [name, key] : largest) {
    const auto group = record.structure.find({name, key.coordinates, "group"}),
               block = record.structure.find({name, key.coordinates, "block"});
    if (group != record.structure.end() && block != record.structure.end())
      section.paragraphs.push_back(what_equations_add(key, group->second, block->second));
  }
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace desmo::report
