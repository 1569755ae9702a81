// What the structure of the equations knows beyond that of the bodies.
#include <array>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr std::array partition_names{"global", "group", "block"};

std::int64_t parts_of(const Structure& structure) {
  std::int64_t sum = 0;
  for (const auto& [unknowns, count] : structure.parts) sum += count;
  return sum;
}

/// "16 + 2×4 + 20×3"
std::string addends(const Structure& structure) {
  std::string text;
  for (const auto& [unknowns, count] : structure.parts)
    text += (text.empty() ? "" : " + ") + (count > 1 ? std::to_string(count) + "×" : "") +
            std::to_string(unknowns);
  return text;
}

}  // namespace

Section partitions(const Record& record) {
  Section section = headed_section("partitions");
  Table table = headed_table("partition_sizes");
  for (auto at = record.structure.begin(); at != record.structure.end();
       at = record.structure.upper_bound({at->first.case_name, at->first.coordinates, "~"})) {
    StructureKey key = at->first;
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
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace desmo::report
