// Does it pay to cut the unknowns where the equations allow it, beyond where the bodies do?
#include <array>
#include <map>
#include <set>

#include "report/statistics/measurements.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr std::array<std::string_view, 3> partition_names{"global", "group", "block"};

// Equations and algebra: what stays the same while the partition changes.
constexpr std::array<std::string_view, 7> methods{
    "automatic_klu",   "symbolic_klu",   "automatic_lapack", "symbolic_lapack",
    "automatic_eigen", "symbolic_eigen", "symbolic_inlined"};

CandidateKey key_of(const std::string& case_name, std::int64_t size, std::string_view partition,
                    std::string_view method) {
  return {case_name, size, std::string(partition) + "_" + std::string(method)};
}

std::set<std::string> cases_of(const Record& record) {
  std::set<std::string> cases;
  for (const auto& [key, structure] : record.structure) cases.insert(key.case_name);
  return cases;
}

std::vector<std::int64_t> sizes_of(const Record& record, const std::string& case_name) {
  std::set<std::int64_t> sizes;
  for (const auto& [key, structure] : record.structure)
    if (key.case_name == case_name) sizes.insert(key.coordinates);
  return {sizes.begin(), sizes.end()};
}

const Structure* find(const Record& record, const std::string& case_name, std::int64_t size,
                      std::string_view partition) {
  const auto it = record.structure.find({case_name, size, std::string(partition)});
  return it == record.structure.end() ? nullptr : &it->second;
}

std::int64_t parts_of(const Structure& structure) {
  std::int64_t count = 0;
  for (const PartSizes& p : structure.parts) count += p.count;
  return count;
}

std::int64_t unknowns_of(const Structure& structure) {
  std::int64_t count = 0;
  for (const PartSizes& p : structure.parts) count += p.count * p.unknowns;
  return count;
}

// Of dense elimination: the sum of n³.
double work_of(const Structure& structure) {
  double work = 0;
  for (const auto& [unknowns, count] : structure.parts) {
    const double n = static_cast<double>(unknowns);
    work += static_cast<double>(count) * n * n * n;
  }
  return work;
}

// "16 + 2×4 + 20×3"
std::string sum(const std::vector<PartSizes>& parts) {
  std::string text;
  for (const auto& [unknowns, count] : parts) {
    if (count == 0) continue;
    text += text.empty() ? "" : " + ";
    if (count > 1) text += std::to_string(count) + "×";
    text += std::to_string(unknowns);
  }
  return text;
}

// What every unit has, so many times, and the rest: "5 × (16 + 2×4) + 2".
std::string composition(const Structure& structure) {
  std::vector<PartSizes> unit, rest;
  std::size_t kinds = 0;
  for (const auto& [unknowns, count] : structure.parts) {
    unit.push_back({unknowns, count / structure.units});
    rest.push_back({unknowns, count % structure.units});
    kinds += unit.back().count > 0;
  }
  if (structure.units == 1 || kinds < 2) return sum(structure.parts);
  const std::string others = sum(rest);
  return std::to_string(structure.units) + " × (" + sum(unit) + ")" +
         (others.empty() ? "" : " + " + others);
}

Entry count_entry(std::int64_t value) {
  const std::string digits = std::to_string(value);
  return {digits, {digits}, {}};
}

Table structure_table(const Record& record) {
  Table table{.name = "partitions",
              .title = "Partitions: into how many parts the unknowns fall",
              .notes = {"Constant parts are left out. Each addend is the unknowns of a part: 2×19 "
                        "are two parts of 19; 5 × (…) are the parts of each of 5 equal units.",
                        "global: all at once; group: the structural groups, from bodies and "
                        "joints; block: the irreducible blocks of each group's equations."},
              .columns = {{"case", {}},
                          {"coordinates", {}},
                          {"partition", {}},
                          {"parts", {"parts"}},
                          {"largest", {"unknowns"}},
                          {"unknowns of the parts", {}}},
              .rows = {}};
  for (const std::string& name : cases_of(record))
    for (const std::int64_t size : sizes_of(record, name))
      for (const std::string_view partition : partition_names)
        if (const Structure* found = find(record, name, size, partition))
          table.rows.push_back({text_entry(name), text_entry(std::to_string(size)),
                                text_entry(std::string(partition)), count_entry(parts_of(*found)),
                                count_entry(found->parts.front().unknowns),
                                text_entry(composition(*found))});
  return table;
}

Table times_table(const Record& record, const std::string& case_name) {
  const std::vector<std::string> seconds{"seconds", "half_range", "repetitions"};
  const std::vector<std::string> ratio{"speed_up", "low", "high", "percent"};
  const TimeWords words = time_words(record);
  Table table{
      .name = "partition_times_" + case_name,
      .title = "Partitions: CPU time in seconds and speed-up, " + case_name,
      .notes = {capitalised(words.time) + " ± half the range of " + repetitions(record) +
                    "; speed-up: with the same equations and algebra, ratio of the " + words.times +
                    " [its interval] (improvement); " + inconclusive_note() + ".",
                "klu finds the irreducible blocks by itself, in every partition."},
      .columns = {{"coordinates", {}},
                  {"equations and algebra", {}},
                  {"global", seconds},
                  {"group", seconds},
                  {"block", seconds},
                  {"group over global", ratio},
                  {"block over global", ratio},
                  {"block over group", ratio}},
      .rows = {},
      .detail = true};
  define_time(table, record);
  for (const std::int64_t size : sizes_of(record, case_name))
    for (const std::string_view method : methods) {
      std::vector<Entry> row{text_entry(std::to_string(size)), text_entry(std::string(method))};
      std::map<std::string_view, Measured> time;
      bool recorded = false;
      for (const std::string_view partition : partition_names) {
        time[partition] = measured(record, key_of(case_name, size, partition, method));
        recorded = recorded || time[partition].mark != missing_mark;
        row.push_back(seconds_entry(time[partition]));
      }
      if (!recorded) continue;
      for (const auto& [reference, variant] :
           {std::pair{"global", "group"}, std::pair{"global", "block"},
            std::pair{"group", "block"}})
        row.push_back(speed_up_entry(measured_speed_up(time[reference], time[variant])));
      table.rows.push_back(std::move(row));
    }
  return table;
}

// "25 groups", "1 group"
std::string counted(std::int64_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// What the equations' structure adds to the bodies', at one size.
std::string knowledge(const Structure& group, const Structure& block) {
  if (parts_of(group) == parts_of(block))
    return "the equations know nothing more: every group is one irreducible block";
  std::int64_t alone = 0;
  for (const PartSizes& p : block.parts)
    if (p.unknowns == 1) alone = p.count;
  const std::string share = write_significant(100 * work_of(block) / work_of(group), 2);
  return "the bodies give " + counted(parts_of(group), "group") + " of up to " +
         counted(group.parts.front().unknowns, "unknown") + ", the equations " +
         counted(parts_of(block), "block") + " of up to " +
         std::to_string(block.parts.front().unknowns) + ": " + std::to_string(alone) + " of the " +
         std::to_string(unknowns_of(block)) +
         " unknowns can be found one at a time, and dense elimination (the sum of n³) has " +
         share + " % of the work";
}

}  // namespace

Section partitions(const Record& record) {
  Section section{.title = "Partitions: global, group, block", .paragraphs = {}, .tables = {}};
  if (record.structure.empty()) return section;
  section.paragraphs.push_back(
      "What does the structure of the equations know that the structure of the bodies does not?");
  for (const std::string& name : cases_of(record)) {
    const std::int64_t size = sizes_of(record, name).back();
    const Structure* group = find(record, name, size, "group");
    const Structure* block = find(record, name, size, "block");
    if (group && block)
      section.paragraphs.push_back("In " + name + ", " + std::to_string(size) + " coordinates, " +
                                   knowledge(*group, *block) + ".");
  }
  section.tables.push_back(structure_table(record));
  for (const std::string& name : cases_of(record))
    section.tables.push_back(times_table(record, name));
  return section;
}

}  // namespace desmo::report
