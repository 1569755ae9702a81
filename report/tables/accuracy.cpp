// Time against error: which sections it makes.
#include <algorithm>

#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

Section accuracy_front(const Record& record) {
  Section section = headed_section("accuracy");
  const Table costs = accuracy_costs(record);
  section.tables.push_back(
      excerpt(costs, headed_table("accuracy_in_short"), [&](const std::vector<Entry>& row) {
        return is_of_last_case(costs, row) && row[3].shown.find("/stride:") == std::string::npos;
      }));
  return section;
}

/// Returns how far the two solutions of the reference differ at most.
double max_floor(const Record& record) {
  double largest = 0;
  for (const auto& [series, floor] : record.floors)
    largest = std::max({largest, floor.reference.position, floor.reference.velocity,
                        floor.reference.acceleration});
  return largest;
}

}  // namespace

std::vector<Section> accuracy_sections(const Record& record) {
  Section figures = headed_section("speed_for_accuracy",
                                   {{"floor", error_entry(max_floor(record)).shown}}),
          costs = headed_section("costs"), reuse = headed_section("guesses"),
          varied = headed_section("table2_varied");
  costs.tables = {accuracy_costs(record)};
  for (const std::string& name : drawn_cases(record))
    figures.tables.push_back(work_precision(record, name));
  reuse.tables = {guesses(record)};
  varied.tables = {sensitivity(record)};
  return {accuracy_front(record), figures, costs, reuse, varied};
}

}  // namespace desmo::report
