#include "report/report.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

std::vector<Section> paper_sections(const Record& record) {
  Section times = headed_section("times");
  times.tables = {figure_of_times(record)};
  std::vector<Section> sections{answer(record), paper_tables(record), std::move(times)};
  const auto add = [&sections](Section section) {
    if (!section.tables.empty()) sections.push_back(std::move(section));
  };
  add(threads(record));
  add(requests(record));
  if (!record.peers.empty()) add(peers(record));
  add(every_formulation(record));
  if (!record.profiles.empty()) add({sentence("time_split.section"), {}, {time_split(record)}});
  return sections;
}

/// Moves the last figure of the second section before the tables of the one in front.
void move_figure_to_front(std::vector<Section>& sections) {
  if (sections.size() < 2) return;
  std::vector<Table>&tables = sections[1].tables, &front = sections.front().tables;
  const auto figure = std::find_if(tables.rbegin(), tables.rend(),
                                   [](const Table& table) { return !table.figure.empty(); });
  if (figure == tables.rend()) return;
  front.insert(front.begin(), std::move(*figure));
  tables.erase(std::next(figure).base());
}

/// Returns the sections of an experiment, the one in front first. Its name and title are those of
/// the block "experiments" in text/texts.txt.
constexpr std::pair<std::string_view, std::vector<Section> (*)(const Record&)> sections_of[] = {
    {"paper", paper_sections},
    {"accuracy", accuracy_sections},
    {"tuning", tuning_sections},
    {"size", size_sections},
    {"instructions", instructions_sections},
    {"extremes", extremes_sections}};

/// A table of each; the names of the later ones are numbered.
Section measured_how(const std::vector<Record>& records) {
  Section section = headed_section("measured");
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
  for (const auto& [name, sections_of_record] : sections_of) {
    const auto experiment = std::ranges::find(experiments, name, &Experiment::name);
    const auto record = std::ranges::find_if(records, experiment->is_in);
    if (record == records.end()) continue;
    const std::string title = sentence("experiments." + std::string(name));
    if (document.title.empty()) document.title = "desmo: " + title;
    std::vector<Section> sections = sections_of_record(*record);
    move_figure_to_front(sections);
    sections.front().front = true;
    for (Section& section : sections) {
      section.chapter = title;
      document.sections.push_back(std::move(section));
    }
  }
  const auto add = [&document](Section section) {
    section.chapter = sentence("about.chapter");
    document.sections.push_back(std::move(section));
  };
  add(measured_how(records));
  add(joint_limitations(records));
  if (const auto with_paper = std::ranges::find_if(records, has_paper); with_paper != records.end())
    if (const auto lines = failures(*with_paper); !lines.empty())
      add({headed_section("failures").title, lines, {}});
  return document;
}

Document make_report(const Record& record) { return make_report(std::vector<Record>{record}); }

}  // namespace desmo::report
