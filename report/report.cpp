#include "report/report.h"

#include <set>

#include "report/measurements.h"
#include "report/paper.h"
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

}  // namespace

Document make_report(const Record& record) {
  Document document{.title = "desmo: the paper's experiment", .sections = {}};
  auto& sections = document.sections;
  sections.push_back(answer(record));
  sections.push_back(paper_figures(record));
  sections.push_back(paper_tables(record));
  sections.push_back(sparse_solvers(record));
  sections.push_back({"Growth with the number of coordinates", {}, {scaling(record)}});
  if (!record.structure.empty()) sections.push_back(partitions(record));
  if (!record.requests.empty()) sections.push_back(requests(record));
  if (!record.peers.empty()) sections.push_back(peers(record));
  sections.push_back(formulations(record));
  if (!record.profiles.empty())
    sections.push_back({"Where the time goes", {}, {time_split(record)}});
  sections.push_back({"How it was measured", {}, {provenance(record)}});
  sections.push_back(limitations(record));
  if (const auto lines = failures(record); !lines.empty())
    sections.push_back({"Failed verification: no time, and no ratio computed from one", lines, {}});
  return document;
}

}  // namespace desmo::report
