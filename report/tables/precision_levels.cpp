// Which errors every formulation can be made to reach.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "report/statistics/selection.h"
#include "report/tables/entries.h"
#include "report/tables/precision.h"

namespace desmo::report {
namespace {

constexpr std::size_t wanted = 4;  // distinct levels
constexpr std::size_t shown = 10;  // formulations that a sentence names

/// The powers of ten between which the errors below 1 lie, each once: 3e-7 and 9e-7 are one level.
std::set<int> decades(const Points& points) {
  std::set<int> found;
  for (const NamedPoint* point : points)
    if (is_solved(*point) && position_error(*point) < 1)
      found.insert(static_cast<int>(std::floor(std::log10(
          std::max(position_error(*point), std::numeric_limits<double>::epsilon() / 2)))));
  return found;
}

/// Series at other steps have one configuration of each formulation.
bool shows_levels(const Record& record, const SeriesKey& series) {
  return series.step_seconds == record.settings.step_seconds;
}

const NamedPoint* extreme(const Points& points, bool largest) {
  const NamedPoint* found = nullptr;
  for (const NamedPoint* point : points)
    if (is_solved(*point) && position_error(*point) < 1 &&
        (!found || (largest ? position_error(*point) > position_error(*found)
                            : position_error(*point) < position_error(*found))))
      found = point;
  return found;
}

std::size_t count(const Points& points, Point::Status status) {
  return static_cast<std::size_t>(std::ranges::count_if(
      points, [&](const NamedPoint* p) { return p->second.status == status; }));
}

}  // namespace

Table error_levels(const Record& record, const std::string& case_name) {
  Table table{
      .name = "error_levels_" + case_name,
      .title = "Levels of error that each formulation reaches: " + case_name,
      .notes = {"Levels: powers of ten between which the largest relative position errors below 1 "
                "of its configurations lie, each counted once, errors below the unit roundoff of "
                "double as that. Dense global formulations are tried over fewer instants."},
      .columns = {{"coordinates", {}},
                  {"instants", {}},
                  {"formulation", {}},
                  {"levels", {"count"}},
                  {"largest", {"error"}},
                  {"least", {"error"}},
                  {"solved", {"count"}},
                  {"failed", {"count"}},
                  {"not applicable", {"count"}}},
      .rows = {},
      .detail = true};
  for (const SeriesKey& series : all_series(record)) {
    if (series.case_name != case_name || !shows_levels(record, series)) continue;
    const Points points = points_of(record, series);
    for (const std::string& name : formulations_of(points)) {
      const Points own = of_formulation(points, name);
      table.rows.push_back({text_entry(std::to_string(series.coordinates)),
                            text_entry(std::to_string(series.instants)), text_entry(name),
                            count_entry(decades(own).size()), error_entry(extreme(own, true)),
                            error_entry(extreme(own, false)),
                            count_entry(count(own, Point::Status::ok)),
                            count_entry(count(own, Point::Status::failed)),
                            count_entry(count(own, Point::Status::not_applicable))});
    }
  }
  return table;
}

std::string min_levels(const Record& record) {
  std::size_t fewest = std::numeric_limits<std::size_t>::max(), all = 0;
  std::vector<std::string> lacking;
  for (const SeriesKey& series : all_series(record)) {
    if (!shows_levels(record, series)) continue;
    const Points points = points_of(record, series);
    for (const std::string& name : formulations_of(points)) {
      const std::size_t levels = decades(of_formulation(points, name)).size();
      fewest = std::min(fewest, levels);
      ++all;
      if (levels < wanted)
        lacking.push_back(series.case_name + "/" + std::to_string(series.coordinates) + "/" + name);
    }
  }
  if (all == 0) return "No series at the record's own step shows levels of error.";
  if (lacking.empty())
    return "Every formulation reaches at least " + std::to_string(fewest) +
           " distinct levels of error at every case and size.";
  std::string text = std::to_string(lacking.size()) + " of " + std::to_string(all) +
                     " formulations at a case and size reach fewer than " + std::to_string(wanted) +
                     " distinct levels of error: ";
  for (std::size_t i = 0; i < std::min(lacking.size(), shown); ++i)
    text += (i == 0 ? "" : ", ") + lacking[i];
  return text + (lacking.size() > shown ? " and others." : ".");
}

}  // namespace desmo::report
