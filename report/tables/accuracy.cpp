// Time against error: what accuracy costs, and what guesses and Jacobian reuse gain.
#include <algorithm>

#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Returns the largest difference of the reference's two solutions, over all series and levels.
double max_floor(const Record& record) {
  double largest = 0;
  for (const auto& [series, floor] : record.floors)
    largest = std::max({largest, floor.reference.position, floor.reference.velocity,
                        floor.reference.acceleration});
  return largest;
}

/// Returns the time of a step of a point; for null missing_mark.
Entry point_time_entry(const NamedPoint* point) {
  return point ? step_time_entry(point->second.time) : note_entry(missing_mark);
}

/// Returns a speed-up with its interval; for null missing_mark.
Entry step_ratio_entry(const NamedPoint* reference, const NamedPoint* variant) {
  if (!reference || !variant) return note_entry(missing_mark);
  if (reference == variant) return reference_entry();
  return ratio_entry(speed_up(reference->second.time, variant->second.time));
}

/// The fastest point with position error ≤ accuracy, and two that it is compared with; null where
/// there is none.
struct Choice {
  Choice(const Points& points, double accuracy)
      : best(cheapest(points, accuracy)),
        same(best ? cheapest_of_paper(points, best->second.configuration.formulation, accuracy)
                  : nullptr),
        global(cheapest_of_paper(points, usual_reference, accuracy)) {}

  /// Returns the speed-up of the best point relative to `global`; both must be there.
  double speed_up_over_global() const {
    return speed_up(global->second.time, best->second.time).value;
  }

  const NamedPoint *best,
      *same,    ///< fastest point of the same formulation with the paper's settings
      *global;  ///< fastest point of the usual reference with the paper's settings
};

/// Shows for each case and each of the accuracies the fastest point that solves every instant.
/// Where an interpolating point is faster, a row for that point follows.
Table accuracy_costs(const Record& record) {
  Table table = headed_table("accuracy_costs");
  for (const SeriesKey& series : drawn_series(record)) {
    const Points points = points_of(record, series), solving = solving_every_instant(points);
    const auto add = [&](double accuracy, const Choice& choice) {
      table.rows.push_back({series.case_name, series.coordinates, write_shortest(accuracy),
                            choice.best ? choice.best->first.id : sentence("costs.none"),
                            point_time_entry(choice.best),
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

constexpr double accuracy = 1e-9;  // limit of the position error in the table of guesses, ≤
constexpr std::array updates{"newton", "step", "chord"};  // only earlier records have "chord"

bool is_tried(const Points& points, std::string_view update) {
  return std::ranges::any_of(points, [&](const NamedPoint* point) {
    return point->second.configuration.jacobian == update;
  });
}

/// Returns words for where steps stop: "tolerance 1e-6", "2 iterations", "usual tolerance".
std::string stop_of(const Configuration& c) {
  std::string text;
  if (!c.iterations.empty()) text = sentence("costs.iterations", {{"count", c.iterations}});
  if (!c.tolerance.empty())
    text += (text.empty() ? "" : ", ") + sentence("costs.tolerance", {{"tolerance", c.tolerance}});
  return text.empty() ? sentence("costs.usual_stop") : text;
}

/// Adds the rows of a case: the usual reference with each guess and Jacobian update, and its
/// speed-ups relative to the usual reference
/// - with all of the paper's settings
/// - with the paper's guess and update, and the end of steps that is fastest within the accuracy
void add_case(Table& table, const SeriesKey& series, const Points& points) {
  const NamedPoint* paper = nullptr;
  for (const NamedPoint* point : points)
    if (point->first.id == usual_reference && is_solved(*point)) paper = point;
  const NamedPoint* const stopped = cheapest_of_paper(points, usual_reference, accuracy);
  const auto best_with = [&](std::string_view guess, std::string_view update,
                             const std::vector<std::string>& others) {
    return cheapest(points, accuracy, [&](const Configuration& c) {
      return c.formulation == usual_reference && c.guess == guess && c.jacobian == update &&
             c.others == others;
    });
  };
  const auto add = [&](const std::string& guess, const std::string& update,
                       const NamedPoint* best) {
    const Point* const point = best ? &best->second : nullptr;
    table.rows.push_back({series.case_name, series.coordinates, guess, update,
                          point ? stop_of(point->configuration) : sentence("costs.no_stop"),
                          error_entry(point ? point->error.position : std::nullopt),
                          number_entry(point ? point->iterations_per_step : std::nullopt, 3),
                          point_time_entry(best), step_ratio_entry(paper, best),
                          step_ratio_entry(stopped, best)});
  };
  for (const std::string& guess : guesses_of(points))
    for (const char* update : updates)
      if (is_tried(points, update)) add(guess, update, best_with(guess, update, {}));
  if (const NamedPoint* per_level = best_with("previous", "newton", {"factorisation:per_level"}))
    add("previous", sentence("guesses_and_updates.per_level"), per_level);
}

/// Shows all pairs of guess and Jacobian update of the usual reference.
Table guesses(const Record& record) {
  Table table = headed_table("guesses_and_updates",
                             {{"tolerance", write_shortest(record.settings.tolerance)}});
  for (const SeriesKey& series : drawn_series(record))
    add_case(table, series, points_of(record, series));
  return table;
}

/// Returns the short section, on the last case. It tells what a step takes at the tightest accuracy
/// that the usual reference reaches, too, and what the loosest accuracy would save.
Section accuracy_front(const Record& record) {
  const SeriesKey series = drawn_series(record).back();
  const Points points = solving_every_instant(points_of(record, series));
  const TextValue loosest("loosest", write_shortest(accuracies.front()));
  const NamedPoint* const cheapest_of_all = cheapest(points, accuracies.front());
  Section section = headed_section("accuracy", {{"floor", error_entry(max_floor(record)).shown}});
  section.paragraphs = {sentence("accuracy.none", {loosest})};
  for (const double accuracy : accuracies) {
    const Choice choice(points, accuracy);
    const bool is_held = choice.best && choice.global;
    const TextValue error("error", write_shortest(accuracy)),
        times("times",
              is_held ? write_significant(choice.speed_up_over_global(), 3) : missing_mark);
    section.numbers.push_back(sentence("accuracy.times", {error, times}));
    if (!is_held) continue;
    const double seconds = step_seconds(*choice.best),
                 saved = 1 - step_seconds(*cheapest_of_all) / seconds;
    section.paragraphs = {
        sentence("accuracy.found", {error,
                                    times,
                                    loosest,
                                    {"case", series.case_name},
                                    {"microseconds", write_significant(1e6 * seconds, 3)},
                                    {"saved", write_fixed(100 * saved, 0)}})};
  }
  section.numbers.erase(section.numbers.begin());  // the index has the three tightest
  const Table costs = accuracy_costs(record);
  section.tables = {
      work_precision(record, series),
      excerpt(costs, headed_table("accuracy_in_short"), [&](const std::vector<Entry>& row) {
        return is_of_last_case(costs, row) && row[3].shown.find("/stride:") == std::string::npos;
      })};
  return section;
}

}  // namespace

std::vector<Section> accuracy_sections(const Record& record) {
  Section others = headed_section("speed_for_accuracy");
  std::vector<SeriesKey> drawn = drawn_series(record);
  drawn.pop_back();  // the last one is in the short section
  for (const SeriesKey& series : drawn) others.tables.push_back(work_precision(record, series));
  return {accuracy_front(record), std::move(others),
          headed_section("costs", {}, {accuracy_costs(record)}),
          headed_section("guesses", {}, {guesses(record)}),
          headed_section("table2_varied", {}, {sensitivity(record)})};
}

}  // namespace desmo::report
