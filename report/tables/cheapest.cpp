// What accuracy costs each formulation: its least time within an error.
#include <algorithm>
#include <functional>
#include <limits>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr double quoted = 1e-9;  // the error at which formulations are compared

/// Counts the configurations of one formulation with settings that every formulation has: not
/// lanes.
std::size_t common_configurations(const Points& own) {
  return static_cast<std::size_t>(std::ranges::count_if(
      own, [](const NamedPoint* p) { return p->second.configuration.others.empty(); }));
}

/// The points of each formulation: those with most configurations first, then the fastest.
std::vector<Points> in_order(const Points& points) {
  std::vector<Points> all;
  for (const std::string& name : formulations_of(points))
    all.push_back(of_formulation(points, name));
  std::ranges::stable_sort(all, {}, [](const Points& own) {
    const NamedPoint* best = cheapest(own, quoted);
    return best ? step_time(*best).seconds : std::numeric_limits<double>::infinity();
  });
  std::ranges::stable_sort(all, std::greater{}, common_configurations);
  return all;
}

/// The cheapest that solves globally, among those with every setting.
const NamedPoint* cheapest_global(const std::vector<Points>& all) {
  const NamedPoint* best = nullptr;
  for (const Points& own : all) {
    const NamedPoint* point = cheapest(own, quoted);
    if (point && common_configurations(own) == common_configurations(all.front()) &&
        point->second.configuration.formulation.starts_with("global_") &&
        (!best || step_time(*point).seconds < step_time(*best).seconds))
      best = point;
  }
  return best;
}

}  // namespace

Table cheapest_by_formulation(const Record& record, const std::string& case_name) {
  const SeriesKey series = *main_series(record, case_name);
  Table table =
      headed_table("cheapest", {{"case", case_name}, {"coordinates", series.coordinates}});
  const std::vector<Points> all = in_order(solving_every_instant(points_of(record, series)));
  const NamedPoint* global = all.empty() ? nullptr : cheapest_global(all);
  for (const Points& own : all) {
    std::vector<Entry> row{own.front()->second.configuration.formulation, count_entry(own.size())};
    for (const double accuracy : accuracies)
      row.push_back(step_time_entry(cheapest(own, accuracy)));
    row.push_back(common_configurations(own) < common_configurations(all.front())
                      ? note_entry(sentence("cheapest.fewer"))
                      : step_ratio_entry(global, cheapest(own, quoted)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
