// Initial guesses and Jacobian reuse, of the formulation that everything is compared with.
#include <algorithm>

#include "report/statistics/selection.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr double accuracy = 1e-9;
constexpr std::array guesses{"previous", "linear", "quadratic", "hermite3", "hermite5", "adams8"};
constexpr std::array updates{"newton", "step", "chord"};

const NamedPoint* find(const Points& points, std::string_view id) {
  for (const NamedPoint* point : points)
    if (point->first.id == id) return is_solved(*point) ? point : nullptr;
  return nullptr;
}

/// The usual formulation, and what its points are held against.
struct Usual {
  explicit Usual(const Points& all)
      : points(solving_every_instant(of_formulation(all, usual_reference))),
        paper(find(points, usual_reference)),
        stopped(cheapest_of_paper(points, accuracy)) {}

  const NamedPoint* best(std::string_view guess, std::string_view update,
                         std::string_view factorisation = "shared") const {
    return cheapest(points, accuracy, [&](const Configuration& c) {
      return c.guess == guess && c.jacobian == update && c.scalar == "double" &&
             c.factorisation == factorisation && c.others.empty();
    });
  }

  Points points;
  const NamedPoint *paper,  ///< with the paper's settings
      *stopped;             ///< with its guesses_and_updates, no further than the accuracy asks
};

void add_rows(Table& table, const SeriesKey& series, const Points& points) {
  const Usual usual(points);
  const auto add = [&](const char* guess, const char* update, const NamedPoint* best) {
    table.rows.push_back(
        {text_entry(series.case_name), text_entry(std::to_string(series.coordinates)),
         text_entry(guess), text_entry(update),
         text_entry(best ? best->second.configuration.stop() : "nothing that holds it"),
         error_entry(best), iterations_entry(best), step_time_entry(best),
         step_ratio_entry(usual.paper, best), step_ratio_entry(usual.stopped, best)});
  };
  for (const char* guess : guesses) {
    const auto is_tried = [&](const NamedPoint* p) {
      return p->second.configuration.guess == guess;
    };
    if (std::ranges::none_of(points, is_tried)) continue;  // a record may be older than a guess
    for (const char* update : updates) add(guess, update, usual.best(guess, update));
  }
  if (const NamedPoint* per_level = usual.best("previous", "newton", "per_level"))
    add("previous", "newton, factors for each level", per_level);
}

std::string gained(const NamedPoint* reference, const NamedPoint* best) {
  const SpeedUp ratio = speed_up(*reference, *best);
  const DigitStyle style = ratio_digits(ratio.value);
  std::string text = write(ratio.value, style);
  if (ratio.spread) text += " [" + write(ratio.low, style) + ", " + write(ratio.high, style) + "]";
  return text + (ratio.inconclusive() ? " (inconclusive)" : "") + " times as fast";
}

}  // namespace

Table guesses_and_updates(const Record& record) {
  Table table{
      .name = "knobs",
      .title = "Knobs of " + std::string(usual_reference) + " at a position error of " +
               write_shortest(accuracy) + " or less",
      .notes = {"Of each guess and Jacobian update the cheapest stop that holds the error. The "
                "paper's settings: previous, newton, at the usual tolerance of " +
                    write_shortest(record.settings.tolerance) +
                    ". At equal error: previous, newton, too, at their cheapest stop.",
                step_time_note()},
      .columns = {{"case", {}},
                  {"coordinates", {}},
                  {"guess", {}},
                  {"Jacobian", {}},
                  {"stop", {}},
                  {"error", {"error"}},
                  {"iterations/step", {"iterations"}},
                  {"µs/step", {"microseconds", "again"}},
                  {"times the paper's settings", {"speed_up", "low", "high"}},
                  {"at equal error", {"speed_up", "low", "high"}}},
      .rows = {}};
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    add_rows(table, series, points_of(record, series));
  }
  return table;
}

std::vector<std::string> what_guesses_gain(const Record& record) {
  std::vector<std::string> lines;
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    const Usual usual(points_of(record, series));
    const NamedPoint* best = cheapest(usual.points, accuracy);
    if (!best || !usual.paper || !usual.stopped) continue;
    lines.push_back(name + ", " + std::to_string(series.coordinates) +
                    " coordinates: " + best->first.id + " is " + gained(usual.paper, best) +
                    " as the paper's settings and " + gained(usual.stopped, best) +
                    " as the paper's knobs at equal error, with an error of " +
                    write_significant(position_error(*best), 2) + ".");
  }
  return lines;
}

}  // namespace desmo::report
