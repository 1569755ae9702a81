// Initial guesses and Jacobian reuse, of the formulation that everything is compared with.
#include <algorithm>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr double accuracy = 1e-9;
constexpr std::array updates{"newton", "step", "chord"};

/// The usual formulation, and what its points are held against.
struct Usual {
  explicit Usual(const Points& all)
      : points(solving_every_instant(of_formulation(all, usual_reference))),
        stopped(cheapest_of_paper(points, accuracy)) {
    for (const NamedPoint* point : points)
      if (point->first.id == usual_reference && is_solved(*point)) paper = point;
  }

  const NamedPoint* best(std::string_view guess, std::string_view update,
                         std::string_view factorisation = "shared") const {
    return cheapest(points, accuracy, [&](const Configuration& c) {
      return c.guess == guess && c.jacobian == update && c.scalar == "double" &&
             c.factorisation == factorisation && c.others.empty();
    });
  }

  Points points;
  const NamedPoint* paper = nullptr;  ///< with the paper's settings
  const NamedPoint* stopped;          ///< with them, no further than the accuracy asks
};

void add_case(Table& table, const SeriesKey& series, const Points& points) {
  const Usual usual(points);
  const auto add = [&](const std::string& guess, const std::string& update,
                       const NamedPoint* best) {
    table.rows.push_back({series.case_name, series.coordinates, guess, update, stop_entry(best),
                          error_entry(best), iterations_entry(best), step_time_entry(best),
                          step_ratio_entry(usual.paper, best),
                          step_ratio_entry(usual.stopped, best)});
  };
  for (const std::string& guess : guesses_of(points))
    for (const char* update : updates) add(guess, update, usual.best(guess, update));
  if (const NamedPoint* per_level = usual.best("previous", "newton", "per_level"))
    add("previous", sentence("guesses_and_updates.per_level"), per_level);
}

}  // namespace

Table guesses(const Record& record) {
  Table table = headed_table("guesses_and_updates",
                             {{"tolerance", write_shortest(record.settings.tolerance)}});
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    add_case(table, series, points_of(record, series));
  }
  return table;
}

}  // namespace desmo::report
