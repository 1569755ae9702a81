// What accuracy costs: the cheapest configuration within an error, what its settings gain, and what
// they give up.
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// The cheapest within an error, and what it is held against.
struct Choice {
  Choice(const Points& points, double accuracy)
      : best(cheapest(points, accuracy)),
        same(best ? cheapest_of_paper(
                        of_formulation(points, best->second.configuration.formulation), accuracy)
                  : nullptr),
        global(cheapest_of_paper(of_formulation(points, usual_reference), accuracy)) {}

  const NamedPoint *best,
      *same,    ///< its formulation with the paper's settings
      *global;  ///< the usual reference with them
};

Entry level_entry(const NamedPoint* point, std::optional<LevelError> Errors::*level,
                  Errors Point::*of) {
  const auto& error = point ? point->second.*of.*level : std::nullopt;
  return error_entry(error ? std::optional(error->max) : std::nullopt);
}

std::vector<Entry> costs_of(const Choice& choice) {
  return {step_time_entry(choice.best), step_ratio_entry(choice.same, choice.best),
          step_ratio_entry(choice.global, choice.best)};
}

std::vector<Entry> errors_of(const Choice& choice) {
  return {level_entry(choice.best, &Errors::position, &Point::error),
          level_entry(choice.best, &Errors::velocity, &Point::error),
          level_entry(choice.best, &Errors::acceleration, &Point::error),
          level_entry(choice.best, &Errors::position, &Point::violation),
          iterations_entry(choice.best),
          stop_entry(choice.same),
          stop_entry(choice.global)};
}

/// Fills a table with the rows of each case: the cheapest that solves every instant, and, where
/// that costs less, the cheapest of all.
Table filled_with(Table table, const Record& record, std::vector<Entry> (*of)(const Choice&)) {
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    const Points points = points_of(record, series), solving = solving_every_instant(points);
    const auto add = [&](double accuracy, const Choice& choice) {
      std::vector<Entry> row{name, series.coordinates, write_shortest(accuracy),
                             choice.best ? choice.best->first.id : sentence("costs.none")};
      std::ranges::move(of(choice), std::back_inserter(row));
      table.rows.push_back(std::move(row));
    };
    for (const double accuracy : accuracies) {
      add(accuracy, Choice(solving, accuracy));
      const Choice among_all(points, accuracy);
      if (among_all.best && !among_all.best->second.configuration.solves_every_instant())
        add(accuracy, among_all);
    }
  }
  return table;
}

}  // namespace

Table accuracy_costs(const Record& record) {
  return filled_with(headed_table("accuracy_costs"), record, costs_of);
}

Table accuracy_errors(const Record& record) {
  return filled_with(headed_table("accuracy_errors"), record, errors_of);
}

}  // namespace desmo::report
