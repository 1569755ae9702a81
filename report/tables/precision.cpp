// Time against error: which sections it makes.
#include "report/tables/precision.h"

#include "report/statistics/selection.h"

namespace desmo::report {
namespace {

Section figures_of(const Record& record) {
  Section section{
      .title = "Speed for accuracy",
      .paragraphs =
          {"Each formulation with each of its settings has a time and an error. Time: CPU "
           "time of a step, assembly and delivery included. Error: in outputs common to "
           "all formulations, against a reference in quadruple precision, relative to the "
           "mechanism's size. What lies on the line is fastest at its error "
           "among those that solve every instant. " +
           max_floor(record)},
      .tables = {}};
  for (const std::string& name : drawn_cases(record))
    section.tables.push_back(work_precision(record, name));
  return section;
}

bool has_interpolated(const Record& record, const std::string& case_name) {
  const Points points = points_of(record, *main_series(record, case_name));
  return solving_every_instant(points).size() < points.size();
}

Section costs(const Record& record) {
  Section section{.title = "What accuracy costs", .paragraphs = {}, .tables = {}};
  section.tables.push_back(accuracy_costs(record));
  section.tables.push_back(accuracy_errors(record));
  for (const std::string& name : drawn_cases(record)) {
    section.tables.push_back(cheapest_by_formulation(record, name));
    if (has_interpolated(record, name))
      section.tables.push_back(cheapest_by_formulation(record, name, Instants::interpolated));
  }
  return section;
}

Section levels(const Record& record) {
  Section section{"Levels of error", {min_levels(record)}, {}};
  for (const std::string& name : cases_with_points(record))
    section.tables.push_back(error_levels(record, name));
  section.tables.push_back(outcomes(record));
  return section;
}

}  // namespace

std::vector<Section> precision_sections(const Record& record) {
  if (record.points.empty()) return {};
  return {figures_of(record),
          costs(record),
          {"Initial guesses and Jacobian reuse",
           what_guesses_gain(record),
           {guesses_and_updates(record)}},
          {"Single and mixed precision", {}, {scalars(record), floors(record)}},
          levels(record),
          {"Sensitivity of the paper's Table 2", {}, {sensitivity(record)}}};
}

}  // namespace desmo::report
