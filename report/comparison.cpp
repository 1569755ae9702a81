#include <algorithm>
#include <set>

#include "report/report.h"
#include "report/statistics/comparability.h"
#include "report/statistics/measurements.h"
#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

std::vector<std::string> origins(const Record& first, const Record& second) {
  std::vector<std::string> lines;
  for (const auto& [name, record] : {std::pair{"A", &first}, {"B", &second}})
    lines.push_back(sentence("comparison.origin", {{"name", name},
                                                   {"date", record->date},
                                                   {"commit", commit_of(*record)},
                                                   {"cpu", record->machine.cpu}}));
  return lines;
}

/// Counts what one has and the other has not.
template <class Map>
std::int64_t only_in(const Map& one, const Map& other) {
  return std::ranges::count_if(one, [&](const auto& e) { return !other.contains(e.first); });
}

/// Adds a row for each key that both have, and of which `entries_of` gives something.
template <class Map, class EntriesOf>
void add_rows(Table& table, const Map& a, const Map& b, const EntriesOf& entries_of) {
  for (const auto& [key, one] : a) {
    const auto other = b.find(key);
    if (other == b.end()) continue;
    const std::vector<Entry> entries = entries_of(key, one, other->second);
    if (entries.empty()) continue;
    std::vector<Entry> row{key.case_name, key.coordinates, key.id};
    row.insert(row.end(), entries.begin(), entries.end());
    table.rows.push_back(std::move(row));
  }
}

Table seconds_of_both(const TimedGroup& a, const TimedGroup& b, const Record& first) {
  Table table = headed_table("comparison", {{"name", a.name},
                                            {"what", a.what},
                                            {"time", time_word(first)},
                                            {"only_a", only_in(a.timings, b.timings)},
                                            {"only_b", only_in(b.timings, a.timings)}});
  define_time(table, first);
  add_rows(table, a.timings, b.timings,
           [](const CandidateKey&, const Timing& one, const Timing& other) {
             std::string remark = one.remark.empty() ? "" : "A: " + one.remark;
             if (!other.remark.empty()) remark += (remark.empty() ? "B: " : "; B: ") + other.remark;
             return std::vector<Entry>{seconds_entry(one.time), seconds_entry(other.time),
                                       ratio_entry(measured_speed_up(one.time, other.time), true),
                                       remark};
           });
  return table;
}

/// What may be shown of a key in a record: nothing of a reference, which is 1 everywhere.
std::optional<SpeedUp> speed_up_of(const TimedGroup& group, const CandidateKey& key,
                                   const Timing& timing) {
  const auto reference = group.timings.find(reference_of(key));
  if (reference == group.timings.end() || reference->first == key) return std::nullopt;
  return measured_speed_up(reference->second.time, timing.time).speed_up;
}

/// Keys of the points of accuracy that stand beside another machine's: of thousands those in front
/// of a figure, and those with the paper's settings.
std::set<CandidateKey> points_in_front(const Record& record) {
  std::set<CandidateKey> keys;
  for (const std::string& name : drawn_cases(record)) {
    const Table drawn = work_precision(record, name);
    const auto column = std::ranges::find(drawn.columns, "Pareto", &Column::name);
    for (const auto& row : drawn.rows)
      if (const std::string& id = row.front().shown;
          !has_settings(id) || !row[column - drawn.columns.begin()].shown.empty())
        keys.insert(timing_key({*main_series(record, name), id}));
  }
  return keys;
}

/// Returns a table for every group in which both have speed-ups.
std::vector<Table> speed_ups_of_both(const Record& first, const Record& second) {
  std::vector<Table> tables;
  const std::set<CandidateKey> in_front = points_in_front(first);
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size(); ++i) {
    Table table =
        headed_table("machines", {{"name", a[i].name.substr(std::string_view("comparison").size())},
                                  {"what", a[i].what},
                                  {"first", first.machine.cpu},
                                  {"first_date", first.date.substr(0, 10)},
                                  {"second", second.machine.cpu},
                                  {"second_date", second.date.substr(0, 10)}});
    add_rows(table, a[i].timings, b[i].timings,
             [&](const CandidateKey& key, const Timing& one, const Timing& other) {
               if (key.id.find("/step:") != key.id.npos && !in_front.contains(key))
                 return std::vector<Entry>();
               const auto x = speed_up_of(a[i], key, one), y = speed_up_of(b[i], key, other);
               return x && y ? std::vector{ratio_entry(*x), ratio_entry(*y)} : std::vector<Entry>();
             });
    if (!table.rows.empty()) tables.push_back(std::move(table));
  }
  return tables;
}

std::size_t rows_in(const std::vector<Table>& tables) {
  std::size_t rows = 0;
  for (const Table& table : tables) rows += table.rows.size();
  return rows;
}

Table counts_of_both(const Record& first, const Record& second) {
  Table table = headed_table("comparison_instructions");
  add_rows(table, first.instructions, second.instructions,
           [](const CandidateKey&, const StepCount& a, const StepCount& b) {
             const double ratio =
                 static_cast<double>(a.instructions) / static_cast<double>(b.instructions);
             return std::vector{digits_entry(std::to_string(a.instructions)),
                                digits_entry(std::to_string(b.instructions)),
                                number_entry(ratio, 3)};
           });
  return table;
}

}  // namespace

Section machines(const Record& record, const std::vector<const Record*>& others) {
  std::map<std::string, std::vector<Table>> best;  // by machine: what has most in common
  for (const Record* other : others) {
    if (!are_of_two_machines(record, *other) || !different_work_reason(record, *other).empty())
      continue;
    std::vector<Table> tables = speed_ups_of_both(record, *other);
    std::vector<Table>& kept = best[other->machine.cpu];
    if (rows_in(tables) > rows_in(kept)) kept = std::move(tables);
  }
  Section section = headed_section("machines_section");
  std::size_t number = 0;
  for (auto& [cpu, tables] : best) {
    number += !tables.empty();
    for (Table& table : tables) {
      if (number > 1) table.name += "_" + std::to_string(number);
      section.tables.push_back(std::move(table));
    }
  }
  return section;
}

Document make_comparison(const Record& first, const Record& second) {
  const bool two = are_of_two_machines(first, second);
  Section section = two ? machines(first, {&second})
                        : Section{sentence("comparison.section"), origins(first, second), {}};
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size() && !two; ++i)
    section.tables.push_back(seconds_of_both(a[i], b[i], first));
  section.tables.push_back(counts_of_both(first, second));
  std::erase_if(section.tables, [](const Table& table) { return table.rows.empty(); });
  return {.title = sentence(two ? "machines_section.document" : "comparison.document"),
          .sections = {std::move(section)}};
}

}  // namespace desmo::report
