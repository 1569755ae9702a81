// What accuracy costs each formulation: its least time within an error.
#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "report/statistics/selection.h"
#include "report/tables/entries.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr double quoted = 1e-9;  // the error at which formulations are compared

/// Configurations of one formulation with guesses_and_updates that every formulation has: not
/// lanes.
std::size_t common_configurations(const Points& own) {
  return static_cast<std::size_t>(std::ranges::count_if(
      own, [](const NamedPoint* p) { return p->second.configuration.others.empty(); }));
}

/// Of how many a formulation has the most: those with fewer had not every knob.
std::size_t max_configurations(const Points& points) {
  std::size_t most = 0;
  for (const std::string& name : formulations_of(points))
    most = std::max(most, common_configurations(of_formulation(points, name)));
  return most;
}

/// The cheapest that solves globally, among those with every knob.
const NamedPoint* cheapest_global(const Points& points, double accuracy) {
  const std::size_t all = max_configurations(points);
  return cheapest(points, accuracy, [&](const Configuration& c) {
    return c.formulation.starts_with("global_") &&
           common_configurations(of_formulation(points, c.formulation)) == all;
  });
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

}  // namespace

Table cheapest_by_formulation(const Record& record, const std::string& case_name,
                              Instants instants) {
  const bool interpolated = instants == Instants::interpolated;
  Table table{
      .name = (interpolated ? "cheapest_interpolated_" : "cheapest_") + case_name,
      .title =
          "The cheapest of each formulation" +
          std::string(interpolated ? ", instants interpolated where that costs less: " : ": ") +
          case_name,
      .notes =
          {"Least µs/step of all configurations of the formulation within each error. Times as "
           "fast: over the cheapest global formulation; both with every "
           "knob. A formulation with fewer configurations than others had not every knob, and "
           "no ratio.",
           step_time_note()},
      .columns = {{"formulation", {}}, {"configurations", {"count"}}},
      .rows = {}};
  const SeriesKey series = *main_series(record, case_name);
  table.title += ", " + std::to_string(series.coordinates) + " coordinates";
  for (const double accuracy : accuracies)
    table.columns.push_back({write_shortest(accuracy), {"microseconds", "again"}});
  table.columns.push_back(
      {"times as fast, " + write_shortest(quoted), {"speed_up", "low", "high"}});

  Points points = points_of(record, series);
  if (!interpolated) points = solving_every_instant(std::move(points));
  const std::size_t all = max_configurations(points);
  const NamedPoint* global = cheapest_global(points, quoted);
  for (const Points& own : in_order(points)) {
    std::vector<Entry> entries{text_entry(own.front()->second.configuration.formulation),
                               count_entry(own.size())};
    for (const double accuracy : accuracies)
      entries.push_back(step_time_entry(cheapest(own, accuracy)));
    entries.push_back(common_configurations(own) < all
                          ? note_entry("fewer knobs")
                          : step_ratio_entry(global, cheapest(own, quoted)));
    table.rows.push_back(std::move(entries));
  }
  return table;
}

}  // namespace desmo::report
