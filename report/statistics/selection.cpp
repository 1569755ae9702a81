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

Points of_formulation(const Points& points, std::string_view formulation) {
  Points found;
  for (const NamedPoint* point : points)
    if (point->second.configuration.formulation == formulation) found.push_back(point);
  return found;
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

bool is_solved(const NamedPoint& point) { return point.second.status == Point::Status::ok; }

double position_error(const NamedPoint& point) { return *point.second.error.position; }

StepTime step_time(std::vector<double> samples) {
  std::ranges::sort(samples);
  return {samples.front(), samples[std::min<std::size_t>(1, samples.size() - 1)]};
}

StepTime step_time(const NamedPoint& point) { return step_time(point.second.seconds_per_step); }

SpeedUp speed_up(const std::vector<double>& reference, const std::vector<double>& variant) {
  const StepTime a = step_time(reference), b = step_time(variant);
  return {.value = a.seconds / b.seconds,
          .low = a.seconds / b.again,
          .high = a.again / b.seconds,
          .percent = 100 * (1 - b.seconds / a.seconds),
          .has_interval = std::min(reference.size(), variant.size()) >= min_for_interval};
}

SpeedUp speed_up(const NamedPoint& reference, const NamedPoint& variant) {
  return speed_up(reference.second.seconds_per_step, variant.second.seconds_per_step);
}

const NamedPoint* cheapest(const Points& points, double max_error,
                           const std::function<bool(const Configuration&)>& may) {
  const NamedPoint* best = nullptr;
  for (const NamedPoint* point : points)
    if (is_solved(*point) && position_error(*point) <= max_error &&
        may(point->second.configuration) &&
        (!best || step_time(*point).seconds < step_time(*best).seconds))
      best = point;
  return best;
}

const NamedPoint* cheapest_of_paper(const Points& points, double max_error) {
  return cheapest(points, max_error,
                  [](const Configuration& c) { return c.has_papers_settings(); });
}

}  // namespace desmo::report
