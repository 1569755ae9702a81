// What the work–precision figure of a case shows, as a table: the design in report/figures draws
// these numbers.
#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "report/statistics/families.h"
#include "report/statistics/selection.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

double seconds_of(const NamedPoint* point) {
  return is_solved(*point) ? step_time(*point).seconds : std::numeric_limits<double>::infinity();
}

/// Of points by time, what is drawn: of each formulation the settings that no others of its own
/// beat in both time and error, and the paper's; and all that failed.
Points drawn(Points points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::map<std::pair<std::string, bool>, double> least;  // by formulation, solving all instants
  std::erase_if(points, [&](const NamedPoint* p) {
    if (!is_solved(*p)) return false;
    const Configuration& c = p->second.configuration;
    double& error =
        least.try_emplace({c.formulation, c.solves_every_instant()}, infinity).first->second;
    if (!(position_error(*p) < error)) return p->first.id != c.formulation;
    error = position_error(*p);
    return false;
  });
  return points;
}

Entry level_entry(const std::optional<LevelError>& error, double LevelError::*value) {
  return error_entry(error ? std::optional((*error).*value) : std::nullopt);
}

std::vector<Entry> row(const NamedPoint& point, bool in_front) {
  const Point& p = point.second;
  const bool solved = is_solved(point);
  return {text_entry(point.first.id),
          text_entry(family_of(p.configuration)),
          solved ? step_time_entry(&point) : note_entry(failed_mark),
          level_entry(p.error.position, &LevelError::max),
          level_entry(p.error.position, &LevelError::rms),
          level_entry(p.error.velocity, &LevelError::max),
          level_entry(p.error.acceleration, &LevelError::max),
          level_entry(p.violation.position, &LevelError::max),
          solved ? iterations_entry(&point) : note_entry(missing_mark),
          text_entry(in_front ? "front" : ""),
          text_entry(p.message)};
}

std::vector<std::string> notes(const Record& record, const SeriesKey& series,
                               const Points& points) {
  const auto count = [&](Point::Status status) {
    return std::to_string(std::ranges::count_if(
        points, [&](const NamedPoint* p) { return p->second.status == status; }));
  };
  return {"Ours: " + record.machine.cpu + ", " + record.date + ". " +
              std::to_string(series.instants) + " instants " + write_shortest(series.step_seconds) +
              " s apart; the least CPU time of a step.",
          count(Point::Status::ok) + " configurations solved, " + count(Point::Status::failed) +
              " failed (below, with their reason), " + count(Point::Status::not_applicable) +
              " not applicable. Of those solved, what no other settings of the same formulation "
              "beat in "
              "time and error at once, and the paper's settings; the record has all.",
          "Numbers beside the line: iterations a step of what is fastest at its error. Black: "
          "global, blue: by groups, yellow: by blocks.",
          "Circles: sparse solvers, squares: dense ones, triangles: generated elimination. Green "
          "diamonds, apart from the line: instants interpolated between solved ones. What is more "
          "than 10 off stands at the right edge."};
}

}  // namespace

Table work_precision(const Record& record, const std::string& case_name) {
  Table table{.name = "work_precision_" + case_name,
              .title = "Work–precision: " + case_name,
              .notes = {},
              .columns = {{"id", {}},
                          {"family", {}},
                          {"µs/step", {"microseconds", "again"}},
                          {"error q", {"error"}},
                          {"rms q", {"error"}},
                          {"error q'", {"error"}},
                          {"error q''", {"error"}},
                          {"violation", {"violation"}},
                          {"iterations/step", {"iterations"}},
                          {"Pareto", {}},
                          {"remark", {}}},
              .rows = {},
              .detail = true,
              .figure = true};
  const SeriesKey series = *main_series(record, case_name);
  table.title += ", " + std::to_string(series.coordinates) + " coordinates";
  Points points = points_of(record, series);
  table.notes = notes(record, series, points);
  std::erase_if(points, [](const NamedPoint* p) {
    return p->second.status == Point::Status::not_applicable;
  });
  std::ranges::stable_sort(points, {}, seconds_of);
  double least = std::numeric_limits<double>::infinity();
  for (const NamedPoint* point : drawn(std::move(points))) {
    const bool in_front = is_solved(*point) && position_error(*point) < least &&
                          point->second.configuration.solves_every_instant();
    if (in_front) least = position_error(*point);
    table.rows.push_back(row(*point, in_front));
  }
  return table;
}

}  // namespace desmo::report
