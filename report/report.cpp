#include "report/report.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "report/measurements.h"
#include "report/paper.h"
#include "report/tables/extremes.h"
#include "report/tables/precision.h"
#include "report/tables/size.h"
#include "report/tables/tables.h"
#include "report/variants.h"

namespace desmo::report {
namespace {

Section paper_tables(const Record& record) {
  Section section{.title = "The paper's tables", .paragraphs = {}, .tables = {}};
  const std::vector<std::string_view> families = recorded_families(record);
  if (families.empty())
    section.paragraphs.push_back("None: the record has no cell of a sparse solver.");
  for (const std::string_view family : families)
    section.tables.push_back(cpu_times(record, family));
  for (const std::string_view family : families)
    section.tables.push_back(speed_ups(record, family));
  return section;
}

Section paper_figures(const Record& record) {
  return {"The paper's figures", {}, {figure_of_speed_ups(record), figure_of_times(record)}};
}

std::set<std::string> recorded_cases(const Record& record) {
  std::set<std::string> cases;
  for (const auto& [key, cell] : record.cells) cases.insert(key.case_name);
  return cases;
}

Section sparse_solvers(const Record& record) {
  Section section = conclusion(record);
  for (const std::string& name : recorded_cases(record))
    if (auto table = references(record, name)) section.tables.push_back(std::move(*table));
  return section;
}

// Each case in full; on the terminal at the paper's largest size, or the largest there is.
Section formulations(const Record& record) {
  Section section{.title = "Every formulation", .paragraphs = {}, .tables = {}};
  for (const std::string& name : recorded_cases(record)) {
    const std::vector<std::int64_t> sizes = recorded_sizes(record, name);
    std::int64_t foremost = sizes.back();
    for (const std::int64_t size : sizes)
      if (size == published_sizes().back()) foremost = size;
    for (const std::int64_t size : sizes) {
      section.tables.push_back(every_formulation(record, name, size));
      section.tables.back().detail = size != foremost;
    }
  }
  return section;
}

void add_experiment(std::vector<Section>& sections, const Record& record) {
  sections.push_back(answer(record));
  sections.push_back(paper_figures(record));
  sections.push_back(paper_tables(record));
  sections.push_back(sparse_solvers(record));
  sections.push_back({"Growth with the number of coordinates", {}, {scaling(record)}});
  if (!record.structure.empty()) sections.push_back(partitions(record));
  if (!record.requests.empty()) sections.push_back(requests(record));
  if (Section section = beyond(record); !section.tables.empty())
    sections.push_back(std::move(section));
  if (!record.peers.empty()) sections.push_back(peers(record));
}

void add_sizes(std::vector<Section>& sections, const Record& record) {
  if (!record.growth.empty()) sections.push_back(growth(record));
  if (!record.break_even.empty()) sections.push_back(dense_or_sparse(record));
}

void add_details(std::vector<Section>& sections, const Record& record) {
  sections.push_back(formulations(record));
  if (!record.profiles.empty())
    sections.push_back({"Where the time goes", {}, {time_split(record)}});
}

/// A table of each; the names of the later ones are numbered.
Section measured_how(const std::vector<Record>& records) {
  Section section{"How it was measured", {}, {}};
  for (const Record& record : records) {
    section.tables.push_back(provenance(record));
    if (const std::size_t count = section.tables.size(); count > 1) {
      section.tables.back().name += "_" + std::to_string(count);
      section.tables.back().title += ", record " + std::to_string(count);
    }
  }
  return section;
}

/// What several records say alike is said once.
Section joint_limitations(const std::vector<Record>& records) {
  Section section = limitations(records.front());
  for (const Record& record : records)
    for (const std::string& line : limitations(record).paragraphs)
      if (std::ranges::find(section.paragraphs, line) == section.paragraphs.end())
        section.paragraphs.push_back(line);
  return section;
}

bool has_accuracy(const Record& r) { return !r.points.empty() || !r.tuning.empty(); }

/// What the first of its sections are about.
std::string title(const std::vector<Record>& records) {
  const auto any = [&](auto has) { return std::ranges::any_of(records, has); };
  return any(has_cells)      ? "desmo: the paper's experiment"
         : any(has_accuracy) ? "desmo: speed for accuracy"
         : any(has_sizes)    ? "desmo: time against size"
         : any([](const Record& r) { return !r.instructions.empty(); })
             ? "desmo: instructions a step"
             : "desmo: stability at the extremes";
}

}  // namespace

Document make_report(const std::vector<Record>& records) {
  const auto end = records.end();
  const auto experiment = std::ranges::find_if(records, has_cells);
  const auto accuracy =
      std::ranges::find_if(records, [](const Record& r) { return !r.points.empty(); });
  const auto tuned =
      std::ranges::find_if(records, [](const Record& r) { return !r.tuning.empty(); });
  const auto grown = std::ranges::find_if(records, has_sizes);
  const auto counted =
      std::ranges::find_if(records, [](const Record& r) { return !r.instructions.empty(); });
  const auto stable =
      std::ranges::find_if(records, [](const Record& r) { return !r.extremes.empty(); });
  Document document{.title = title(records), .sections = {}};
  auto& sections = document.sections;
  if (experiment != end) add_experiment(sections, *experiment);
  if (accuracy != end)
    std::ranges::move(precision_sections(*accuracy), std::back_inserter(sections));
  if (tuned != end) sections.push_back(tuning(*tuned));
  if (grown != end) add_sizes(sections, *grown);
  if (counted != end) sections.push_back(instructions(*counted));
  if (stable != end) sections.push_back(extremes(*stable));
  if (experiment != end) add_details(sections, *experiment);
  sections.push_back(measured_how(records));
  sections.push_back(joint_limitations(records));
  if (experiment != end)
    if (const auto lines = failures(*experiment); !lines.empty())
      sections.push_back(
          {"Failed verification: no time, and no ratio computed from one", lines, {}});
  return document;
}

Document make_report(const Record& record) { return make_report(std::vector<Record>{record}); }

}  // namespace desmo::report
