// Table 2 of the paper: S = t_global / t_topological.
#include <set>

#include "report/statistics/measurements.h"
#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"

namespace desmo::report {
namespace {

Entry size_entry(const Record& record, std::string_view family, std::size_t variant,
                 std::int64_t size) {
  return speed_up_entry(measured_speed_up(record, family_key(variants[truck_global], size, family),
                                          family_key(variants[variant], size, family)));
}

}  // namespace

Entry published_speed_up_entry(const std::string& row, const Variant& variant) {
  const std::string value = published_speed_up().text(row, variant.paper_name);
  const std::string percent = published_improvement_percent().text(row, variant.paper_name);
  if (value.empty()) return note_entry(missing_mark);
  return {value + " (" + percent + " %)", {value, "", "", percent}, {}};
}

Table speed_ups(const Record& record, std::string_view family) {
  const std::string reference = family_name(variants[truck_global], family);
  Table table{
      .name = "table2_" + std::string(family),
      .title = "Table 2 (" + std::string(family) + "): speed-up over " + reference +
               " and improvement, truck suspension",
      .notes =
          {"Ours: ratio of the " + time_words(record).times + " S over " + reference +
               ", [its interval], improvement 100(1 − 1/S); " + inconclusive_note() +
               ". The paper: over TS-G_MA27; in or out of our interval, as printed.",
           "Mean: arithmetic, of each quantity, over the paper's sizes; incomplete: over fewer, so "
           "not to be compared."},
      .columns = {{"coordinates", {}}, {"source", {}}},
      .rows = {}};
  define_time(table, record);
  if (const Sources source = sources(record); !source.ratio_warning.empty())
    table.notes.push_back(source.ratio_warning);
  for (const std::size_t variant : topological)
    table.columns.push_back(
        {family_name(variants[variant], family), {"speed_up", "low", "high", "percent"}});

  std::set<std::int64_t> sizes(published_sizes().begin(), published_sizes().end());
  for (const auto& [key, candidate] : record.candidates)
    for (const std::size_t variant : topological)
      if (key == family_key(variants[variant], key.coordinates, family))
        sizes.insert(key.coordinates);
  std::vector<std::string> names;
  for (const std::int64_t size : sizes) names.push_back(std::to_string(size));
  names.push_back("mean");

  auto size = sizes.begin();
  for (const std::string& name : names) {
    std::vector<Entry> ours{text_entry(name), text_entry("ours")};
    std::vector<Entry> paper{text_entry(name), text_entry("paper")};
    bool published = false;
    for (const std::size_t variant : topological) {
      ours.push_back(name == "mean" ? mean_speed_up_entry(record, family, variant)
                                    : size_entry(record, family, variant, *size));
      paper.push_back(compared(published_speed_up_entry(name, variants[variant]), ours.back()));
      published = published || paper.back().note != missing_mark;
    }
    if (size != sizes.end()) ++size;
    table.rows.push_back(std::move(ours));
    if (published) table.rows.push_back(std::move(paper));
  }
  return table;
}

}  // namespace desmo::report
