// What float and mixed precision buy and cost, and what conditioning let expect.
#include <algorithm>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr std::array scalar_names{"double", "mixed", "float"};
constexpr std::array asked{1e-3, 1e-6, 1e-9};

template <class Holds>
Points points_with(const Points& points, Holds holds) {
  Points found;
  std::ranges::copy_if(points, std::back_inserter(found), holds);
  return found;
}

Points of_scalar(const Points& points, std::string_view scalar) {
  return points_with(points, [&](const NamedPoint* point) {
    return point->second.configuration.scalar == scalar;
  });
}

/// The guesses and updates that were tried with another scalar, too.
Points tried_with(const Points& points, const Points& other) {
  return points_with(points, [&](const NamedPoint* point) {
    return std::ranges::any_of(other, [&](const NamedPoint* o) {
      const Configuration &a = point->second.configuration, &b = o->second.configuration;
      return a.guess == b.guess && a.jacobian == b.jacobian && a.factorisation == b.factorisation &&
             a.others == b.others;
    });
  });
}

const NamedPoint* best_error(const Points& solved) {
  const auto best = std::ranges::min_element(
      solved, {}, [](const NamedPoint* point) { return position_error(*point); });
  return best == solved.end() ? nullptr : *best;
}

Entry predicted_entry(const Floor& floor, std::string_view scalar) {
  const auto& limit = scalar == "float" ? floor.in_float : floor.in_double;
  return error_entry(limit ? std::optional(limit->position) : std::nullopt);
}

void add_scalars(Table& table, const Record& record, const SeriesKey& series, const Points& own) {
  const Points others = points_with(
      own, [](const NamedPoint* point) { return point->second.configuration.scalar != "double"; });
  if (std::ranges::all_of(others, [](const NamedPoint* p) {
        return p->second.status == Point::Status::not_applicable;
      }))
    return;
  const Points in_double = tried_with(of_scalar(own, "double"), others);
  for (const char* scalar : scalar_names) {
    const Points points = scalar == std::string_view("double") ? in_double : of_scalar(own, scalar);
    if (points.empty()) continue;
    const Points solved = points_with(points, [](const auto* p) { return is_solved(*p); });
    const NamedPoint* best = best_error(solved);
    const std::string count = std::to_string(solved.size()), all = std::to_string(points.size());
    const std::string& message = points.front()->second.message;
    std::vector<Entry> row{series.case_name,
                           own.front()->second.configuration.formulation,
                           scalar,
                           {count + " of " + all, {count, all}, {}},
                           error_entry(best),
                           step_time_entry(best),
                           predicted_entry(record.floors.at(series), scalar)};
    for (const double error : asked)
      row.push_back(step_ratio_entry(cheapest(in_double, error), cheapest(points, error)));
    row.push_back(best ? std::string() : message.substr(0, message.find(" at t = ")));
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

Table scalars(const Record& record) {
  Table table = headed_table("scalars");
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    const Points points = points_of(record, series);
    for (const std::string& formulation : formulations_of(points))
      add_scalars(table, record, series, of_formulation(points, formulation));
  }
  return table;
}

}  // namespace desmo::report
