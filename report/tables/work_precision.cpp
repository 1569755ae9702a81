// The data of the work–precision figure of a case, which a design in report/figures draws.
#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Returns the partition and the kind of algebra of a formulation, such as "group, sparse"; where
/// not every instant is solved, "interpolated".
std::string family_of(const Configuration& configuration) {
  if (!configuration.solves_every_instant()) return "interpolated";
  const std::string& id = configuration.formulation;
  return id.substr(0, id.find('_')) + ", " + algebra_kind(id);
}

double seconds_of(const NamedPoint* point) {
  return is_solved(*point) ? step_seconds(*point) : std::numeric_limits<double>::infinity();
}

/// Returns the points that are drawn. points: the fastest first.
/// - solved ones whose error is smaller than that of every faster one of the same formulation and
///   scalar; points that interpolate are compared with such points only
/// - solved ones with the paper's settings
/// - all that failed
Points drawn(Points points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::map<std::tuple<std::string, std::string, bool>, double> least;
  std::erase_if(points, [&](const NamedPoint* p) {
    if (!is_solved(*p)) return false;
    const Configuration& c = p->second.configuration;
    const std::string scalar(setting(p->first.id, "scalar"));
    double& error = least.try_emplace({c.formulation, scalar, c.solves_every_instant()}, infinity)
                        .first->second;
    if (!(position_error(*p) < error)) return p->first.id != c.formulation;
    error = position_error(*p);
    return false;
  });
  return points;
}

std::vector<Entry> point_row(const NamedPoint& point, bool in_front) {
  const Point& p = point.second;
  const bool solved = is_solved(point);
  return {point.first.id,
          family_of(p.configuration),
          solved ? step_time_entry(p.time) : note_entry(failed_mark),
          error_entry(p.error.position),
          error_entry(p.error.velocity),
          error_entry(p.error.acceleration),
          solved ? number_entry(p.iterations_per_step, 3) : note_entry(missing_mark),
          in_front ? "front" : "",
          p.message};
}

std::int64_t count_of(const Points& points, Status status) {
  return std::ranges::count_if(points,
                               [&](const NamedPoint* p) { return p->second.status == status; });
}

}  // namespace

Table work_precision(const Record& record, const SeriesKey& series) {
  Points points = points_of(record, series);
  Table table = headed_table("work_precision",
                             {{"case", series.case_name},
                              {"coordinates", series.coordinates},
                              {"cpu", record.machine.cpu},
                              {"date", record.date},
                              {"instants", series.instants},
                              {"step", write_shortest(series.step_seconds)},
                              {"solved", count_of(points, Status::ok)},
                              {"failed", count_of(points, Status::failed)},
                              {"not_applicable", count_of(points, Status::not_applicable)}});
  std::erase_if(points,
                [](const NamedPoint* p) { return p->second.status == Status::not_applicable; });
  std::ranges::stable_sort(points, {}, seconds_of);
  double least = std::numeric_limits<double>::infinity();
  for (const NamedPoint* point : drawn(std::move(points))) {
    const bool in_front = is_solved(*point) && position_error(*point) < least &&
                          point->second.configuration.solves_every_instant();
    if (in_front) least = position_error(*point);
    table.rows.push_back(point_row(*point, in_front));
  }
  const Floor& floor = record.floors.at(series);
  const auto add_line = [&](const char* name, double at) {
    table.lines.emplace_back(sentence(name, {{"error", error_entry(at).shown}}), at);
  };
  add_line("work_precision.floor", floor.reference.position);
  if (floor.in_double) add_line("work_precision.in_double", floor.in_double->position);
  if (floor.in_float) add_line("work_precision.in_float", floor.in_float->position);
  return table;
}

}  // namespace desmo::report
