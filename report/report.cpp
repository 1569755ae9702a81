#include "report/report.h"

#include <algorithm>
#include <map>

#include "report/read/readers.h"
#include "report/statistics/paper.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

std::vector<Section> paper_sections(const Record& record) {
  return {answer(record),
          paper_tables(record),
          every_formulation(record),
          headed_section("times", {}, {figure_of_times(record)}),
          threads(record),
          requests(record),
          checks(record),
          peers(record),
          headed_section("time_split_section", {}, {time_split(record)})};
}

/// Names of experiments, with functions that return their sections, the short one first. The block
/// "experiments" in text/texts.txt has a title for each name.
constexpr std::pair<std::string_view, std::vector<Section> (*)(const Record&)> sections_of[] = {
    {"paper", paper_sections},
    {"accuracy", accuracy_sections},
    {"size", size_sections},
    {"modelling", modelling_sections},
    {"instructions", instructions_sections},
    {"extremes", extremes_sections}};

/// Returns a table of speed-ups as a detail. If it has more than 200 rows, keeps those of one size
/// of each case: of the paper's largest size, or, where that is missing, of the case's largest.
Table on_page(Table table) {
  constexpr std::size_t max_rows = 200;
  table.detail = true;
  if (table.rows.size() <= max_rows) return table;
  const std::string published = std::to_string(published_sizes().back());
  std::map<std::string, std::string> kept;  // size by case; rows are in the order of sizes
  for (const auto& row : table.rows)
    if (std::string& size = kept[row[0].shown]; size != published) size = row[1].shown;
  std::erase_if(table.rows, [&](const auto& row) { return kept[row[0].shown] != row[1].shown; });
  return table;
}

}  // namespace

Document make_report(const Record& record, const std::vector<const Record*>& beside) {
  Document document;
  const auto add = [&document](Section section, const std::string& chapter) {
    section.chapter = chapter;
    document.add(std::move(section));
  };
  for (const auto& [name, sections_of_record] : sections_of) {
    if (!std::ranges::find(experiments, name, &Experiment::name)->is_in(record)) continue;
    const std::string title = sentence("experiments." + std::string(name));
    if (document.title.empty()) document.title = "desmo: " + title;
    std::vector<Section> sections = sections_of_record(record);
    sections.front().front = true;
    for (Section& section : sections) add(std::move(section), title);
  }
  Section others = machines(record, beside);
  for (Table& table : others.tables) table = on_page(std::move(table));
  if (others.tables.empty()) others.paragraphs = {sentence("machines_section.none")};
  if (!beside.empty()) add(std::move(others), sentence("machines_section.chapter"));
  const std::string about = sentence("about.chapter");
  add(headed_section("measured", {}, {provenance(record)}), about);
  add(limitations(record), about);
  add({headed_section("failures").title, failures(record), {}}, about);
  return document;
}

}  // namespace desmo::report
