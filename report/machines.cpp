// Speed-ups of a record next to those of other machines.
#include <algorithm>
#include <set>

#include "report/report.h"
#include "report/statistics/comparability.h"
#include "report/statistics/measurements.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Returns the speed-up of a key relative to reference_of() it. Returns nothing for the reference
/// itself, and where one of the two has no time.
std::optional<SpeedUp> speed_up_of(const TimedGroup& group, const CandidateKey& key,
                                   const Measurement& variant) {
  const auto reference = group.measurements.find(reference_of(key));
  if (reference == group.measurements.end() || reference->first == key) return std::nullopt;
  return measured_speed_up(measured(*reference->second), measured(variant)).speed_up;
}

/// Returns the timing_key() of those points of the accuracy experiment that are compared with
/// another machine's. Of thousands of points, they are those that work_precision() marks as Pareto
/// points ("front"), and the drawn ones whose id has no settings.
std::set<CandidateKey> points_in_front(const Record& record) {
  std::set<CandidateKey> keys;
  for (const SeriesKey& series : drawn_series(record)) {
    const Table drawn = work_precision(record, series);
    const auto column = std::ranges::find(drawn.columns, "Pareto", &Column::name);
    for (const auto& row : drawn.rows)
      if (const std::string& id = row.front().shown;
          !has_settings(id) || !row[column - drawn.columns.begin()].shown.empty())
        keys.insert(timing_key({series, id}));
  }
  return keys;
}

/// Returns a table for every group (timed_groups()) in which both records have a speed-up of the
/// same key.
std::vector<Table> speed_ups_of_both(const Record& first, const Record& second) {
  std::vector<Table> tables;
  const std::set<CandidateKey> in_front = points_in_front(first);
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size(); ++i) {
    Table table = headed_table("machines", {{"name", a[i].name},
                                            {"what", a[i].what},
                                            {"first", first.machine.cpu},
                                            {"first_date", first.date.substr(0, 10)},
                                            {"second", second.machine.cpu},
                                            {"second_date", second.date.substr(0, 10)}});
    for (const auto& [key, one] : a[i].measurements) {
      const auto other = b[i].measurements.find(key);
      if (other == b[i].measurements.end()) continue;
      if (key.id.find("/step:") != key.id.npos && !in_front.contains(key)) continue;
      const auto x = speed_up_of(a[i], key, *one), y = speed_up_of(b[i], key, *other->second);
      if (x && y)
        table.rows.push_back(
            {key.case_name, key.coordinates, key.id, ratio_entry(*x), ratio_entry(*y)});
    }
    if (!table.rows.empty()) tables.push_back(std::move(table));
  }
  return tables;
}

std::size_t rows_in(const std::vector<Table>& tables) {
  std::size_t rows = 0;
  for (const Table& table : tables) rows += table.rows.size();
  return rows;
}

}  // namespace

Section machines(const Record& record, const std::vector<const Record*>& others) {
  std::map<std::string, std::vector<Table>> best;  // by CPU: the tables with most rows
  for (const Record* other : others) {
    if (record.machine.cpu == other->machine.cpu || !different_work_reasons(record, *other).empty())
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

}  // namespace desmo::report
