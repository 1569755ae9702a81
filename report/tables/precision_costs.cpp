// What accuracy costs: the cheapest configuration within an error, what its settings gain, and what
// they give up.
#include "report/statistics/selection.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

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
      *same,    ///< its formulation with the paper's guesses_and_updates
      *global;  ///< the usual reference with them
};

std::vector<Entry> beginning(const SeriesKey& series, double accuracy, const NamedPoint* best) {
  return {text_entry(series.case_name), text_entry(std::to_string(series.coordinates)),
          text_entry(write_shortest(accuracy)), text_entry(best ? best->first.id : "none")};
}

const std::vector<Column>& first_columns() {
  static const std::vector<Column> columns{
      {"case", {}}, {"coordinates", {}}, {"error at most", {}}, {"cheapest", {}}};
  return columns;
}

Entry stop_entry(const NamedPoint* point) {
  return text_entry(point ? point->second.configuration.stop() : "nothing that holds it");
}

Entry level_entry(const NamedPoint* point, std::optional<LevelError> Errors::*level,
                  Errors Point::*of) {
  const auto& error = point ? point->second.*of.*level : std::nullopt;
  return error_entry(error ? std::optional(error->max) : std::nullopt);
}

std::vector<Entry> costs_row(const SeriesKey& series, double accuracy, const Choice& choice) {
  std::vector<Entry> row = beginning(series, accuracy, choice.best);
  row.push_back(step_time_entry(choice.best));
  row.push_back(step_ratio_entry(choice.same, choice.best));
  row.push_back(step_ratio_entry(choice.global, choice.best));
  return row;
}

std::vector<Entry> errors_row(const SeriesKey& series, double accuracy, const Choice& choice) {
  std::vector<Entry> row = beginning(series, accuracy, choice.best);
  for (auto level : {&Errors::position, &Errors::velocity, &Errors::acceleration})
    row.push_back(level_entry(choice.best, level, &Point::error));
  row.push_back(level_entry(choice.best, &Errors::position, &Point::violation));
  row.push_back(iterations_entry(choice.best));
  row.push_back(stop_entry(choice.same));
  row.push_back(stop_entry(choice.global));
  return row;
}

template <class Row>
void fill(Table& table, const Record& record, Row row) {
  table.columns.insert(table.columns.begin(), first_columns().begin(), first_columns().end());
  for (const std::string& name : drawn_cases(record)) {
    const SeriesKey series = *main_series(record, name);
    const Points points = points_of(record, series), solving = solving_every_instant(points);
    for (const double accuracy : accuracies) {
      table.rows.push_back(row(series, accuracy, Choice(solving, accuracy)));
      const Choice among_all(points, accuracy);
      if (among_all.best && !among_all.best->second.configuration.solves_every_instant())
        table.rows.push_back(row(series, accuracy, among_all));
    }
  }
}

}  // namespace

Table accuracy_costs(const Record& record) {
  Table table{
      .name = "accuracy_costs",
      .title = "What accuracy costs: the cheapest configuration within an error",
      .notes = {"Error: largest relative position error of the motion. Times as fast at the same "
                "error: as the same formulation, and as " +
                    std::string(usual_reference) +
                    ", with the paper's guess and Jacobian in double precision, stopped where they "
                    "hold the error at the least cost. A second row, with /stride, stands where "
                    "interpolating instants between solved ones costs less than solving them all.",
                step_time_note()},
      .columns = {{"µs/step", {"microseconds", "again"}},
                  {"times as fast as with the paper's knobs", {"speed_up", "low", "high"}},
                  {"as " + std::string(usual_reference) + " with them",
                   {"speed_up", "low", "high"}}},
      .rows = {}};
  fill(table, record, costs_row);
  return table;
}

Table accuracy_errors(const Record& record) {
  Table table{
      .name = "accuracy_errors",
      .title = "What is given up: the errors of the cheapest configurations",
      .notes = {"Largest errors of the motion: q relative to the mechanism's size, q' and q'' to "
                "its largest speed and acceleration; violation: of the equations of position. "
                "Paper's knobs: where the same formulation and " +
                std::string(usual_reference) + " were stopped, to be compared with."},
      .columns = {{"error q", {"error"}},
                  {"error q'", {"error"}},
                  {"error q''", {"error"}},
                  {"violation", {"violation"}},
                  {"iterations/step", {"iterations"}},
                  {"paper's knobs", {}},
                  {std::string(usual_reference), {}}},
      .rows = {}};
  fill(table, record, errors_row);
  return table;
}

}  // namespace desmo::report
