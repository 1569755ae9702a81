// Which global reference is chosen decides the speed-up: the same formulations over each of them.
#include <algorithm>
#include <array>

#include "report/statistics/measurements.h"
#include "report/statistics/paper.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"

namespace desmo::report {
namespace {

constexpr std::array<std::string_view, 5> by_parts{
    "group_automatic_lapack", "group_symbolic_lapack", "group_symbolic_klu",
    "group_symbolic_inlined", "block_symbolic_inlined"};

// Of the paper's sizes the largest recorded; the largest of all where there is none of them.
std::int64_t size_shown(const std::vector<std::int64_t>& recorded) {
  std::int64_t shown = recorded.back();
  for (const std::int64_t size : published_sizes())
    if (std::find(recorded.begin(), recorded.end(), size) != recorded.end()) shown = size;
  return shown;
}

// Those with a time, fastest first.
std::vector<CandidateKey> references_of(const Record& record, const std::string& case_name,
                                        std::int64_t size) {
  std::vector<std::pair<double, CandidateKey>> found;
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == case_name && key.coordinates == size && key.id.starts_with("global_"))
      if (const Measured time = measured(record, key); time.seconds)
        found.emplace_back(time.seconds->value, key);
  std::sort(found.begin(), found.end());
  std::vector<CandidateKey> keys;
  for (auto& [seconds, key] : found) keys.push_back(std::move(key));
  return keys;
}

// The paper's own reference, where one of its variants stands for the column.
std::vector<Entry> paper_row(const std::vector<std::string_view>& columns, std::int64_t size) {
  const std::string name = std::to_string(size);
  std::vector<Entry> row{text_entry(paper_solver),
                         published_seconds_entry(name, variants[truck_global])};
  for (const std::string_view id : columns) {
    const auto variant =
        std::find_if(topological.begin(), topological.end(),
                     [&](std::size_t candidate) { return variants[candidate].id == id; });
    row.push_back(variant == topological.end()
                      ? note_entry(missing_mark)
                      : without_percent(published_speed_up_entry(name, variants[*variant])));
  }
  return row;
}

}  // namespace

std::optional<Table> references(const Record& record, const std::string& case_name) {
  const std::vector<std::int64_t> sizes = recorded_sizes(record, case_name);
  if (sizes.empty()) return std::nullopt;
  const std::int64_t size = size_shown(sizes);
  const std::vector<CandidateKey> rows = references_of(record, case_name, size);
  std::vector<std::string_view> columns;
  for (const std::string_view id : by_parts)
    if (record.candidates.contains({case_name, size, std::string(id)})) columns.push_back(id);
  if (rows.empty() || columns.empty()) return std::nullopt;

  const TimeWords words = time_words(record);
  Table table{
      .name = "references_" + case_name,
      .title = "Which global reference: speed-up over each of them, " + case_name + ", " +
               std::to_string(size) + " coordinates",
      .notes = {"Fastest reference first, " + words.time + words.beside + " of " +
                repetitions(record) + "; speed-up: ratio of the " + words.times +
                " [its interval]; " + inconclusive_note() + "."},
      .columns = {{"global reference", {}}, {"CPU s", {"seconds", "median", "repetitions"}}},
      .rows = {}};
  define_time(table, record);
  for (const std::string_view id : columns)
    table.columns.push_back({std::string(id), {"speed_up", "low", "high"}});
  for (const CandidateKey& reference : rows) {
    std::vector<Entry> row{text_entry(reference.id), median_entry(measured(record, reference))};
    for (const std::string_view id : columns)
      row.push_back(without_percent(speed_up_entry(
          measured_speed_up(record, reference, {case_name, size, std::string(id)}))));
    table.rows.push_back(std::move(row));
  }
  const auto& published = published_sizes();
  if (case_name == variants[truck_global].case_name &&
      std::find(published.begin(), published.end(), size) != published.end()) {
    table.rows.push_back(paper_row(columns, size));
    if (const Sources source = sources(record); !source.warning.empty())
      table.notes.push_back(source.warning);
  }
  return table;
}

}  // namespace desmo::report
