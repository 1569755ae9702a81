// What figures 5 and 6 show, as tables: the designs in report/figures draw these numbers.
#include "report/statistics/paper.h"
#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// How the paper's own solver is named next to the families.
constexpr const char* paper_solver = "MA27 (the paper)";

/// What stands under the same line of the legend in every panel: TS-TPA_MA27 -> TS-TPA sparse.
std::string legend(const Variant& variant) {
  std::string name = family_name(variant, "sparse");
  for (char& c : name)
    if (c == '_') c = ' ';
  return name.ends_with("LAP") ? name + "ACK" : name;
}

TextValues values_of(const Record& record) {
  return {{"cpu", record.machine.cpu},
          {"date", record.date.substr(0, 10)},
          {"repetitions", repetitions(record)},
          {"time", time_and_median(record)},
          {"duration", write_shortest(record.settings.duration_seconds)}};
}

/// Adds a row for each size; `entry_of` gives a variant's time at a size.
template <typename EntryOf>
void add_panel(Table& table, const std::string& name, EntryOf entry_of) {
  for (const std::int64_t size : published_sizes()) {
    std::vector<Entry> row{name, size};
    for (const Variant& variant : variants) row.push_back(entry_of(size, variant));
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

Table figure_of_times(const Record& record) {
  const Sources source = sources(record);
  const bool same = source.warning.empty();
  Table table = headed_table("figure5", values_of(record));
  if (!same) table.notes.push_back(source.warning);
  table.notes.push_back(sentence("figure5.paper_machine"));
  table.notes.push_back(sentence("figure5.lines"));
  for (const Variant& variant : variants)
    table.columns.push_back({legend(variant), {"seconds", "median", "repetitions"}});
  add_panel(table, same ? paper_solver : "MA27 (the " + source.paper + ")",
            [](std::int64_t size, const Variant& variant) {
              return published_seconds_entry(std::to_string(size), variant);
            });
  for (const std::string_view family : recorded_families(record))
    add_panel(table, std::string(family) + (same ? "" : " (" + source.ours + ")"),
              [&](std::int64_t size, const Variant& variant) {
                return seconds_entry(measured(record, family_key(variant, size, family)),
                                     Spread::median);
              });
  return table;
}

Table figure_of_speed_ups(const Record& record) {
  Table table = headed_table("figure6", values_of(record));
  if (const Sources source = sources(record); !source.ratio_warning.empty())
    table.notes.push_back(source.ratio_warning);
  const std::vector<std::string> quantities{"speed_up", "low", "high"};
  table.columns.push_back({paper_solver, quantities});
  for (const std::string_view family : recorded_families(record))
    table.columns.push_back({std::string(family), quantities});
  for (const std::size_t variant : topological) {
    std::vector<Entry> row{legend(variants[variant]),
                           published_speed_up_entry("mean", variants[variant], false)};
    for (const std::string_view family : recorded_families(record))
      row.push_back(mean_speed_up_entry(record, family, variant));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
