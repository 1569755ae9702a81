// What float and mixed precision buy and cost, and what conditioning let expect.
#include <algorithm>
#include <map>

#include "report/statistics/selection.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr std::array names{"double", "mixed", "float"};
constexpr std::array asked{1e-3, 1e-6, 1e-9};

Points of_scalar(const Points& points, std::string_view scalar) {
  Points found;
  for (const NamedPoint* point : points)
    if (point->second.configuration.scalar == scalar) found.push_back(point);
  return found;
}

const NamedPoint* best_error(const Points& points) {
  const NamedPoint* best = nullptr;
  for (const NamedPoint* point : points)
    if (is_solved(*point) && (!best || position_error(*point) < position_error(*best)))
      best = point;
  return best;
}

/// The guesses and updates that were tried with another scalar, too.
Points tried_with(const Points& points, const Points& other) {
  Points found;
  for (const NamedPoint* point : points)
    if (std::ranges::any_of(other, [&](const NamedPoint* o) {
          const Configuration &a = point->second.configuration, &b = o->second.configuration;
          return a.guess == b.guess && a.jacobian == b.jacobian &&
                 a.factorisation == b.factorisation && a.others == b.others;
        }))
      found.push_back(point);
  return found;
}

Entry limit_entry(const Floor& floor, std::string_view scalar) {
  const auto& limit = scalar == "float" ? floor.in_float : floor.in_double;
  return error_entry(limit ? std::optional(limit->position) : std::nullopt);
}

Entry solved_entry(const Points& points) {
  const std::string solved =
      std::to_string(std::ranges::count_if(points, [](const auto* p) { return is_solved(*p); }));
  const std::string all = std::to_string(points.size());
  return {solved + " of " + all, {solved, all}, {}};
}

/// Why none is solved; empty when some are.
std::string reason(const Points& points) {
  if (std::ranges::any_of(points, [](const auto* p) { return is_solved(*p); })) return {};
  const Point& first = points.front()->second;
  const bool refused = first.status == Point::Status::not_applicable;
  return (refused ? "not applicable: " : "") + kind_of_failure(first.message);
}

/// Those of other scalars than the paper's.
Points of_others(const Points& own) {
  Points others = of_scalar(own, "mixed");
  for (const NamedPoint* point : of_scalar(own, "float")) others.push_back(point);
  return others;
}

bool offers_none(const Points& others) {
  return std::ranges::all_of(others, [](const NamedPoint* p) {
    return p->second.status == Point::Status::not_applicable;
  });
}

void add_formulation(Table& table, const Record& record, const SeriesKey& series,
                     const Points& own) {
  const Points others = of_others(own);
  const Points in_double = tried_with(of_scalar(own, "double"), others);
  for (const char* scalar : names) {
    const Points points = scalar == std::string_view("double") ? in_double : of_scalar(own, scalar);
    if (points.empty()) continue;
    const NamedPoint* best = best_error(points);
    std::vector<Entry> row{text_entry(series.case_name),
                           text_entry(own.front()->second.configuration.formulation),
                           text_entry(scalar),
                           solved_entry(points),
                           error_entry(best),
                           step_time_entry(best),
                           limit_entry(record.floors.at(series), scalar)};
    for (const double accuracy : asked)
      row.push_back(step_ratio_entry(cheapest(in_double, accuracy), cheapest(points, accuracy)));
    row.push_back(text_entry(reason(points)));
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

Table scalars(const Record& record) {
  Table table{
      .name = "scalars",
      .title = "Single and mixed precision beside double",
      .notes =
          {"At each case's largest size, with the guesses and Jacobian updates that were tried "
           "with all scalars. Least error: of position, the largest of the motion, and the time "
           "of that configuration. Predicted: κ u in position, with the largest condition "
           "number κ of the motion and the unit roundoff u of double, for mixed, too, whose "
           "residuals and corrections are double, or of float. Times as fast: the cheapest "
           "within each error over the cheapest in double.",
           step_time_note()},
      .columns = {{"case", {}},
                  {"formulation", {}},
                  {"scalar", {}},
                  {"solved", {"solved", "tried"}},
                  {"least error", {"error"}},
                  {"µs/step", {"microseconds", "again"}},
                  {"predicted", {"error"}}},
      .rows = {}};
  for (const double accuracy : asked)
    table.columns.push_back(
        {"times as fast, " + write_shortest(accuracy), {"speed_up", "low", "high"}});
  table.columns.push_back({"remark", {}});
  std::map<std::string, std::string> refused;
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    const Points points = points_of(record, series);
    for (const std::string& formulation : formulations_of(points)) {
      const Points own = of_formulation(points, formulation), others = of_others(own);
      if (others.empty()) continue;
      if (offers_none(others))
        refused[formulation] = kind_of_failure(others.front()->second.message);
      else
        add_formulation(table, record, series, own);
    }
  }
  std::string reasons;
  for (const auto& [formulation, why] : refused)
    reasons += (reasons.empty() ? "" : ", ") + formulation + " (" + why + ")";
  if (!reasons.empty()) table.notes.push_back("Offered neither by " + reasons + ".");
  return table;
}

}  // namespace desmo::report
