// What became of every configuration: nothing that was tried is dropped.
#include <map>

#include "report/statistics/selection.h"
#include "report/tables/entries.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {

std::string kind_of_failure(std::string_view message) {
  return std::string(message.empty() ? "no reason recorded"
                                     : message.substr(0, message.find(" at t = ")));
}

Table outcomes(const Record& record) {
  Table table{.name = "outcomes",
              .title = "What became of every configuration",
              .notes = {"A configuration without an answer is counted here, with its reason, and "
                        "has no time. Examples: the first by name."},
              .columns = {{"case", {}},
                          {"coordinates", {}},
                          {"step s", {}},
                          {"instants", {}},
                          {"outcome", {}},
                          {"count", {"count"}},
                          {"example", {}}},
              .rows = {}};
  using Outcome = std::pair<Point::Status, std::string>;
  for (const SeriesKey& series : all_series(record)) {
    std::map<Outcome, std::vector<std::string>> found;
    for (const NamedPoint* point : points_of(record, series)) {
      const Point& p = point->second;
      const bool solved = p.status == Point::Status::ok;
      found[{p.status, solved ? "" : kind_of_failure(p.message)}].push_back(point->first.id);
    }
    for (const auto& [outcome, ids] : found) {
      const auto& [status, why] = outcome;
      table.rows.push_back(
          {text_entry(series.case_name), text_entry(std::to_string(series.coordinates)),
           text_entry(write_shortest(series.step_seconds)),
           text_entry(std::to_string(series.instants)),
           text_entry(status == Point::Status::ok       ? "solved"
                      : status == Point::Status::failed ? "failed: " + why
                                                        : "not applicable: " + why),
           count_entry(ids.size()), text_entry(status == Point::Status::ok ? "" : ids.front())});
    }
  }
  return table;
}

}  // namespace desmo::report
