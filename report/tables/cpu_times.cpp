// Table 1 of the paper.
#include <set>

#include "report/statistics/measurements.h"
#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

std::set<std::int64_t> rows_of(const Record& record, std::string_view family) {
  std::set<std::int64_t> sizes(published_sizes().begin(), published_sizes().end());
  sizes.insert(published_four_bar);
  for (const auto& [key, candidate] : record.candidates)
    for (const Variant& variant : variants)
      if (key == family_key(variant, key.coordinates, family)) sizes.insert(key.coordinates);
  return sizes;
}

std::string solver_of_the_paper(std::string_view family) {
  return family == papers_own ? "MA27, too" : "MA27 in place of " + std::string(family);
}

}  // namespace

Entry published_seconds_entry(const std::string& row, const Variant& variant) {
  const PublishedTable& table = published_cpu_seconds();
  const std::string digits = table.text(row, variant.paper_name);
  if (digits.empty()) return note_entry(missing_mark);
  if (!table.number(row, variant.paper_name)) return note_entry(digits);  // "<<0.015"
  return {digits, {digits, "", ""}, {}};
}

Table cpu_times(const Record& record, std::string_view family) {
  const std::string duration = write_shortest(record.settings.duration_seconds);
  const Sources source = sources(record);
  const TimeWords words = time_words(record);
  Table table{
      .name = "table1_" + std::string(family),
      .title = "Table 1 (" + std::string(family) + "): CPU time in seconds of " + duration +
               " s of motion" + (source.warning.empty() ? "" : " (the " + source.paper + ")") +
               ", all coordinates",
      .notes = {"Ours: " + words.time + words.beside + " of " + repetitions(record) +
                    ". The paper: " + solver_of_the_paper(family) +
                    ", MKL's LAPACK, an Intel Core i5-2400: ratios compare, seconds do not.",
                "The paper has no row " + std::to_string(published_four_bar) +
                    ": it says that FBL-TP takes 1000 coordinates to begin to show times "
                    "above 0.015 s."},
      .columns = {{"coordinates", {}}, {"source", {}}},
      .rows = {}};
  define_time(table, record);
  if (!source.warning.empty()) table.notes.push_back(source.warning);
  for (const Variant& variant : variants)
    table.columns.push_back({family_name(variant, family), {"seconds", "median", "repetitions"}});
  for (const std::int64_t size : rows_of(record, family)) {
    const std::string row = std::to_string(size);
    std::vector<Entry> ours{text_entry(row), text_entry(source.ours)};
    std::vector<Entry> paper{text_entry(row), text_entry(source.paper)};
    bool published = false;
    for (const Variant& variant : variants) {
      ours.push_back(median_entry(measured(record, family_key(variant, size, family))));
      paper.push_back(published_seconds_entry(row, variant));
      published = published || paper.back().note != missing_mark;
    }
    table.rows.push_back(std::move(ours));
    if (published) table.rows.push_back(std::move(paper));
  }
  return table;
}

}  // namespace desmo::report
