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

}  // namespace

/// Fills in each case: the cheapest that solves every instant, and, where that costs less, the
/// cheapest of all.
Table accuracy_costs(const Record& record) {
  Table table = headed_table("accuracy_costs");
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    const Points points = points_of(record, series), solving = solving_every_instant(points);
    const auto add = [&](double accuracy, const Choice& choice) {
      table.rows.push_back({name, series.coordinates, write_shortest(accuracy),
                            choice.best ? choice.best->first.id : sentence("costs.none"),
                            step_time_entry(choice.best),
                            step_ratio_entry(choice.same, choice.best),
                            step_ratio_entry(choice.global, choice.best)});
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

}  // namespace desmo::report
