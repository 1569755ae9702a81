// Tables 1 and 2 of the paper: CPU seconds, and S = t_global / t_topological. The data of figures 5
// and 6, which the designs in report/figures draw.
#include <algorithm>
#include <iterator>
#include <set>

#include "report/statistics/paper.h"
#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Returns the paper's sizes, and those at which one of the variants was recorded in a family.
std::set<std::int64_t> sizes_with(const Record& record, std::string_view family,
                                  std::span<const PaperVariant> shown) {
  std::set<std::int64_t> sizes(published_sizes().begin(), published_sizes().end());
  for (const auto& [key, candidate] : record.candidates)
    for (const PaperVariant& variant : shown)
      if (key == family_key(variant, key.coordinates, family)) sizes.insert(key.coordinates);
  return sizes;
}

/// Adds our row, and below it the paper's, if the paper prints anything there. Entries of numbers
/// begin in the third column.
void add_both(Table& table, std::vector<Entry> ours, std::vector<Entry> paper) {
  bool published = false;
  for (std::size_t i = 2; i < paper.size(); ++i)
    published = published || paper[i].note != missing_mark;
  table.rows.push_back(std::move(ours));
  if (published) table.rows.push_back(std::move(paper));
}

/// Returns the CPU time [s] that the paper prints of a variant in a row of its table 1 ("114" …
/// "mean"); a note where that is no number.
Entry published_seconds_entry(const std::string& row, const PaperVariant& variant) {
  const std::string digits = published(published_cpu_seconds, row, variant.paper_name);
  if (digits.empty()) return note_entry(missing_mark);
  return read_number(digits) ? digits_entry(digits) : note_entry(digits);  // no number: "<<0.015"
}

/// Returns the speed-up that the paper prints of a variant in a row of its table 2. Of the
/// quantities {speed_up, low, high, percent}, low and high are missing.
Entry published_speed_up_entry(const std::string& row, const PaperVariant& variant,
                               bool with_percent = true) {
  const std::string value = published(published_speed_up, row, variant.paper_name);
  if (value.empty()) return note_entry(missing_mark);
  if (!with_percent) return composed("{}", {value, "", ""});
  return composed("{} ({} %)", {value, "", "",
                                published(published_improvement_percent, row, variant.paper_name)});
}

/// Returns the mean speed-up over the paper's sizes. A mean of fewer sizes, which cannot be
/// compared with the paper's, has the note "incomplete 4/5".
Entry mean_speed_up_entry(const Record& record, std::string_view family,
                          const PaperVariant& variant, bool with_percent = false) {
  const std::vector<std::int64_t>& sizes = published_sizes();
  const MeanSpeedUp mean = mean_speed_up(record, family, variant);
  if (!mean.speed_up) return note_entry(missing_mark);
  Entry entry = ratio_entry(*mean.speed_up, with_percent);
  if (mean.sizes == sizes.size()) return entry;
  add_note(entry, "incomplete " + std::to_string(mean.sizes) + "/" + std::to_string(sizes.size()));
  return entry;
}

/// Returns the paper's value with inside_mark where our interval contains it, both as printed, and
/// with outside_mark where it does not. Returns it unchanged where the value or the interval is
/// missing, or our mean is incomplete.
Entry compared(Entry published, const Entry& ours) {
  const bool incomplete = ours.note.find("incomplete") != std::string::npos;
  if (!published.has_number() || incomplete || ours.digits.size() < 3) return published;
  const std::optional<double> value = read_number(published.digits[0]),
                              low = read_number(ours.digits[1]), high = read_number(ours.digits[2]);
  if (!value || !low || !high) return published;
  published.note = *low <= *value && *value <= *high ? inside_mark : outside_mark;
  published.shown += " " + published.note;
  return published;
}

/// Shows table 1 of the paper for one sparse family: CPU seconds of every analysis, ours above the
/// paper's. Its sizes are the paper's, published_four_bar, and others that were recorded.
Table cpu_times(const Record& record, std::string_view family) {
  const Sources source = sources(record);
  const char* const solver = family == papers_own ? "table1.ma27_too" : "table1.ma27_in_place";
  Table table = headed_table(
      "table1", timed_words(record, {{"family", family},
                                     {"paper_motion", source.warning.empty()
                                                          ? ""
                                                          : sentence("table1.other_motion",
                                                                     {{"paper", source.paper}})},
                                     {"paper_solver", sentence(solver, {{"family", family}})}}));
  if (!source.warning.empty()) table.notes.push_back(source.warning);
  for (const PaperVariant& variant : paper_variants)
    table.columns.push_back({family_name(variant, family), {"seconds", "median", "repetitions"}});
  std::set<std::int64_t> sizes = sizes_with(record, family, paper_variants);
  sizes.insert(published_four_bar);
  for (const std::int64_t size : sizes) {
    const std::string row = std::to_string(size);
    std::vector<Entry> ours{row, source.ours}, paper{row, source.paper};
    for (const PaperVariant& variant : paper_variants) {
      ours.push_back(
          seconds_entry(measured(record, family_key(variant, size, family)), Spread::median));
      paper.push_back(published_seconds_entry(row, variant));
    }
    add_both(table, std::move(ours), std::move(paper));
  }
  return table;
}

/// Shows table 2 of the paper for one sparse family: speed-up and improvement, ours above the
/// paper's, which is marked as in or out of our interval. The family's solver is used in the sparse
/// columns and in the global reference.
Table speed_ups(const Record& record, std::string_view family) {
  Table table = headed_table(
      "table2",
      timed_words(record, {{"family", family}, {"reference", family_name(truck_global, family)}}));
  if (const Sources source = sources(record); !source.ratio_warning.empty())
    table.notes.push_back(source.ratio_warning);
  for (const PaperVariant& variant : topological)
    table.columns.push_back({family_name(variant, family), {"speed_up", "low", "high", "percent"}});
  const auto add = [&](const std::string& name, const auto& ours_of) {
    std::vector<Entry> ours{name, "ours"}, paper{name, "paper"};
    for (const PaperVariant& variant : topological) {
      ours.push_back(ours_of(variant));
      paper.push_back(compared(published_speed_up_entry(name, variant), ours.back()));
    }
    add_both(table, std::move(ours), std::move(paper));
  };
  for (const std::int64_t size : sizes_with(record, family, topological))
    add(std::to_string(size), [&](const PaperVariant& variant) {
      return ratio_entry(measured_speed_up(record, family_key(truck_global, size, family),
                                           family_key(variant, size, family)),
                         true);
    });
  add("mean", [&](const PaperVariant& variant) {
    return mean_speed_up_entry(record, family, variant, true);
  });
  return table;
}

/// Name of the paper's times or speed-ups, next to those of the families.
constexpr const char* paper_solver = "MA27 (the paper)";

/// Returns the name of a variant in legends, which is the same for all families: "TS-TPA sparse"
/// for TS-TPA_MA27, "TS-TPA LAPACK" for TS-TPA_LAP.
std::string legend(const PaperVariant& variant) {
  std::string name = family_name(variant, "sparse");
  for (char& c : name)
    if (c == '_') c = ' ';
  return name.ends_with("LAP") ? name + "ACK" : name;
}

/// Adds a row for each of the paper's sizes. entry_of: function that returns a variant's time at a
/// size.
template <typename EntryOf>
void add_panel(Table& table, const std::string& name, EntryOf entry_of) {
  for (const std::int64_t size : published_sizes()) {
    std::vector<Entry> row{name, size};
    for (const PaperVariant& variant : paper_variants) row.push_back(entry_of(size, variant));
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

Section paper_tables(const Record& record) {
  Section section = headed_section("paper");
  for (const std::string_view family : recorded_families(record, truck_case))
    section.tables.push_back(speed_ups(record, family));
  for (const std::string_view family : recorded_families(record))
    section.tables.push_back(cpu_times(record, family));
  return section;
}

Table figure_of_times(const Record& record) {
  const Sources source = sources(record);
  const bool same = source.warning.empty();
  Table table = headed_table("figure5", timed_words(record));
  if (!same) table.notes.push_back(table.caption = source.warning);
  table.notes.push_back(sentence("figure5.paper_machine"));
  table.notes.push_back(sentence("figure5.lines"));
  for (const PaperVariant& variant : paper_variants)
    table.columns.push_back({legend(variant), {"seconds", "median", "repetitions"}});
  Table ours = table;
  for (const std::string_view family : recorded_families(record))
    add_panel(ours, std::string(family) + (same ? "" : " (" + source.ours + ")"),
              [&](std::int64_t size, const PaperVariant& variant) {
                return seconds_entry(measured(record, family_key(variant, size, family)),
                                     Spread::median);
              });
  if (!ours.has_marks()) return table;  // the paper's times alone say nothing of the record
  add_panel(table, same ? paper_solver : "MA27 (the " + source.paper + ")",
            [](std::int64_t size, const PaperVariant& variant) {
              return published_seconds_entry(std::to_string(size), variant);
            });
  std::ranges::move(ours.rows, std::back_inserter(table.rows));
  return table;
}

Table figure_of_speed_ups(const Record& record) {
  Table table = headed_table("figure6", timed_words(record));
  if (const Sources source = sources(record); !source.ratio_warning.empty())
    table.notes.push_back(table.caption = source.ratio_warning);
  const std::vector<std::string> quantities{"speed_up", "low", "high"};
  table.columns.push_back({paper_solver, quantities});
  std::vector<std::string_view> families = recorded_families(record, truck_case);
  std::erase_if(families, [&](std::string_view family) {
    return std::ranges::none_of(topological, [&](const PaperVariant& variant) {
      return mean_speed_up_entry(record, family, variant).has_number();
    });
  });
  if (families.empty()) return table;  // the paper's speed-ups alone say nothing of the record
  for (const std::string_view family : families)
    table.columns.push_back({std::string(family), quantities});
  for (const PaperVariant& variant : topological) {
    std::vector<Entry> row{legend(variant), published_speed_up_entry("mean", variant, false)};
    for (const std::string_view family : families)
      row.push_back(mean_speed_up_entry(record, family, variant));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
