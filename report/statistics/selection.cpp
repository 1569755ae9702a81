#include "report/statistics/selection.h"

#include <algorithm>
#include <set>

namespace desmo::report {

std::vector<SeriesKey> drawn_series(const Record& record) {
  std::vector<SeriesKey> all;
  for (const auto& [key, point] : record.points) {  // in the order of series
    if (key.series.step_seconds != record.settings.step_seconds) continue;
    if (all.empty() || all.back().case_name != key.series.case_name) all.emplace_back();
    all.back() = key.series;
  }
  return all;
}

Points points_of(const Record& record, const SeriesKey& series) {
  Points points;
  for (const NamedPoint& point : record.points)
    if (point.first.series == series) points.push_back(&point);
  return points;
}

Points solving_every_instant(Points points) {
  std::erase_if(
      points, [](const NamedPoint* p) { return !p->second.configuration.solves_every_instant(); });
  return points;
}

std::vector<std::string> guesses_of(const Points& points) {
  const std::string paper = Configuration().guess;
  std::set<std::string> others;
  for (const NamedPoint* point : points) others.insert(point->second.configuration.guess);
  std::vector<std::string> names{paper};
  others.erase(paper);
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

const NamedPoint* cheapest(const Points& points, double max_error,
                           const std::function<bool(const Configuration&)>& may) {
  const NamedPoint* best = nullptr;
  for (const NamedPoint* point : points)
    if (is_solved(*point) && position_error(*point) <= max_error &&
        may(point->second.configuration) && (!best || step_seconds(*point) < step_seconds(*best)))
      best = point;
  return best;
}

const NamedPoint* cheapest_of_paper(const Points& points, std::string_view formulation,
                                    double max_error) {
  return cheapest(points, max_error, [&](const Configuration& c) {
    return c.formulation == formulation && c.has_papers_settings();
  });
}

}  // namespace desmo::report
