#include "report/report.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

#include "report/statistics/measurements.h"
#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/tables/extremes.h"
#include "report/tables/in_short.h"
#include "report/tables/precision.h"
#include "report/tables/size.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

Section paper_tables(const Record& record) {
  Section section{.title = "The paper's tables", .paragraphs = {}, .tables = {}};
  const std::vector<std::string_view> families = recorded_families(record);
  if (families.empty())
    section.paragraphs.push_back("None: the record has no cell of a sparse solver.");
  for (const std::string_view family : families)
    section.tables.push_back(speed_ups(record, family));
  for (const std::string_view family : families)
    section.tables.push_back(cpu_times(record, family));
  return section;
}

std::set<std::string> recorded_cases(const Record& record) {
  std::set<std::string> cases;
  for (const auto& [key, candidate] : record.candidates) cases.insert(key.case_name);
  return cases;
}

Section global_references(const Record& record) {
  Section section{.title = "Which global reference", .paragraphs = {}, .tables = {}};
  for (const std::string& name : recorded_cases(record))
    if (auto table = references(record, name)) section.tables.push_back(std::move(*table));
  return section;
}

// Each case in full; other sizes than the paper's largest, or the largest there is, are details.
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

std::vector<Section> paper_sections(const Record& record) {
  std::vector<Section> sections{
      answer(record),
      paper_tables(record),
      {"Time over the number of coordinates", {}, {figure_of_times(record), scaling(record)}}};
  const auto add = [&sections](Section section) {
    if (!section.tables.empty()) sections.push_back(std::move(section));
  };
  add(global_references(record));
  add(beyond(record));
  if (!record.structure.empty()) sections.push_back(partitions(record));
  if (!record.requests.empty()) sections.push_back(requests(record));
  if (!record.peers.empty()) sections.push_back(peers(record));
  add(formulations(record));
  if (!record.profiles.empty())
    sections.push_back({"Where the time goes", {}, {time_split(record)}});
  return sections;
}

/// Moves the last figure of a section before the tables of the one in front.
void move_figure_to_front(std::vector<Section>& sections, std::size_t from) {
  std::vector<Table>&tables = sections.at(from).tables, &front = sections.front().tables;
  const auto figure = std::find_if(tables.rbegin(), tables.rend(), std::mem_fn(&Table::figure));
  if (figure == tables.rend()) return;
  front.insert(front.begin(), std::move(*figure));
  tables.erase(std::next(figure).base());
}

std::vector<Section> accuracy_sections(const Record& record) {
  std::vector<Section> sections{accuracy_in_short(record)};
  std::ranges::move(precision_sections(record), std::back_inserter(sections));
  move_figure_to_front(sections, 1);
  return sections;
}

std::vector<Section> size_sections(const Record& record) {
  std::vector<Section> sections{size_in_short(record)};
  if (!record.growth.empty()) {
    sections.push_back(growth(record));
    move_figure_to_front(sections, 1);
  }
  if (!record.break_even.empty()) sections.push_back(dense_or_sparse(record));
  return sections;
}

/// What a record may have, and the sections it then gives, those in front first.
struct Experiment {
  const char* title;
  bool (*is_in)(const Record&);
  std::vector<Section> (*sections)(const Record&);
};

const std::vector<Experiment>& reported_experiments() {
  static const std::vector<Experiment> all{
      {"The paper's experiment", has_paper, paper_sections},
      {"Accuracy", [](const Record& r) { return !r.points.empty(); }, accuracy_sections},
      {"Accuracy of desmo tune", [](const Record& r) { return !r.tuning.empty(); },
       [](const Record& r) {
         return std::vector{tuning_in_short(r), tuning(r)};
       }},
      {"Size", has_sizes, size_sections},
      {"Instructions", [](const Record& r) { return !r.instructions.empty(); },
       [](const Record& r) {
         return std::vector{instructions_in_short(r), instructions(r)};
       }},
      {"Extremes", [](const Record& r) { return !r.extremes.empty(); },
       [](const Record& r) {
         return std::vector{extremes_in_short(r), extremes(r)};
       }}};
  return all;
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

}  // namespace

Document make_report(const std::vector<Record>& records) {
  Document document{.title = {}, .sections = {}};
  for (const Experiment& experiment : reported_experiments()) {
    const auto record = std::ranges::find_if(records, experiment.is_in);
    if (record == records.end()) continue;
    if (document.title.empty()) document.title = "desmo: " + std::string(experiment.title);
    std::vector<Section> sections = experiment.sections(*record);
    sections.front().front = true;
    for (Section& section : sections) {
      section.chapter = experiment.title;
      document.sections.push_back(std::move(section));
    }
  }
  const auto add = [&document](Section section) {
    section.chapter = "About the record";
    document.sections.push_back(std::move(section));
  };
  add(measured_how(records));
  add(joint_limitations(records));
  if (const auto with_paper = std::ranges::find_if(records, has_paper); with_paper != records.end())
    if (const auto lines = failures(*with_paper); !lines.empty())
      add({"Failed verification: no time, and no ratio computed from one", lines, {}});
  return document;
}

Document make_report(const Record& record) { return make_report(std::vector<Record>{record}); }

}  // namespace desmo::report
