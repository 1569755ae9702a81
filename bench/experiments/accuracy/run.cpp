// desmo_bench accuracy: time against error, for formulations and the settings that trade one for
// the other.
#include <CLI/CLI.hpp>
#include <cmath>
#include <list>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/accuracy/series.h"
#include "bench/experiments/accuracy/trial.h"
#include "bench/experiments/experiments.h"
#include "bench/kit/process/progress.h"
#include "formulations/base/per_level.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/condition.h"

namespace desmo::accuracy {

namespace {

using Json = nlohmann::ordered_json;

constexpr int compared_instants = 21;
constexpr int usual_repetitions = 5, quick_repetitions = 2;
constexpr double sample_seconds = 0.01;      // least duration of a sample [s]
constexpr double long_motion_seconds = 0.3;  // a motion that takes longer [s] has two samples

double rounded(double value) { return bench::rounded(value, 6); }

/// Returns the errors by level. Leaves out a level at which nothing was compared, or whose error is
/// too large or not finite: JSON has no number for it.
Json error_json(const SolutionError& error) {
  constexpr double max_error = 1e100;
  Json j = Json::object();
  for (const Level level : all_levels) {
    const LevelError& e = error[level];
    if (e.compared > 0 && e.max <= max_error && std::isfinite(e.rms))
      j[level_names[level]] = {{"max", rounded(e.max)}, {"rms", rounded(e.rms)}};
  }
  return j;
}

Json motion_json(const AccuracySeries& series) {
  return {{"case", series.definition->name},
          {"coordinates", series.coordinates},
          {"step_seconds", series.step},
          {"instants", series.instants}};
}

/// Returns an entry of `floors` in the record: what is known of a problem without its trials.
Json floor_json(const AccuracySeries& series, const Problem& problem) {
  Json j = motion_json(series);
  j["compared"] = problem.reference.instants.size();
  j["reference"] = bench::per_level_json(problem.reference.floor);
  const double k = max_condition(problem);
  if (!std::isfinite(k)) return j;  // singular somewhere: nothing can be predicted
  j["condition"] = k;
  j["limit"] = {{"double", bench::per_level_json(accuracy_limit(k, std::ldexp(1, -53)))},
                {"float", bench::per_level_json(accuracy_limit(k, std::ldexp(1, -24)))}};
  return j;
}

/// Returns an entry of `points` in the record: a point of the work–precision diagram.
Json point_json(const AccuracySeries& series, const Trial& trial) {
  Json j = motion_json(series);
  j["id"] = trial.id();
  j["status"] = trial.is_verified() ? "ok" : trial.is_not_run() ? "not_applicable" : "failed";
  if (!trial.is_verified()) {
    j["message"] = trial.message();
    return j;
  }
  j["error"] = error_json(trial.error);
  j["iterations_per_step"] = rounded(trial.verifying_run().iterations_per_step);
  j["time_per_step"] = bench::rounded_time_json(trial.seconds());
  return j;
}

/// Compares every configuration, then times them in turn, so that whatever slows the machine down
/// for a while meets them all.
void measure(const AccuracySeries& series, const Problem& problem, int repetitions, Json& points,
             bench::Progress& progress) {
  std::list<Trial> trials;
  for (const Configuration& c : series.configurations) {
    trials.emplace_back(problem, c).verify();
    progress.add_done();
  }
  for (int round = 0; round < repetitions; ++round)
    for (Trial& trial : trials) {
      if (!trial.has_enough_samples(long_motion_seconds)) trial.time(sample_seconds);
      progress.add_done();
    }
  for (const Trial& trial : trials) points.push_back(point_json(series, trial));
}

void measure_all(const bench::CommonOptions& options, const bench::CommandLine& line) {
  const std::vector<AccuracySeries> all = make_series(options.quick, std::regex(options.filter));
  if (all.empty()) throw std::invalid_argument("no configuration matches " + options.filter);
  bench::RecordWriter recording = begin_record(options, line);
  const int repetitions = options.samples(usual_repetitions, quick_repetitions);
  std::size_t trials = 0;
  for (const AccuracySeries& series : all) trials += series.configurations.size();
  bench::Progress progress("comparisons and samples",
                           static_cast<double>(trials) * (1 + repetitions));
  Json lists = {{"floors", Json::array()}, {"points", Json::array()}};
  TimeGrid usual;
  for (const AccuracySeries& series : all) {
    const Model whole = make_model(make_scene(*series.definition, series.coordinates));
    const TimeGrid grid = time_grid(series.step * (series.instants - 1), series.step);
    if (&series == &all.front()) usual = grid;
    const Problem problem = bench::make_problem(make_plan(whole, {}), grid, compared_instants);
    lists["floors"].push_back(floor_json(series, problem));
    measure(series, problem, repetitions, lists["points"], progress);
  }
  recording.write(usual, lists);
}

}  // namespace

bench::ExitCode run(const bench::CommandLine& line) {
  bench::CommonOptions options;
  CLI::App parser("desmo_bench accuracy: time against error of formulations and their settings.");
  bench::add_common(
      parser, options,
      {.quick = "the smallest sizes, eleven formulations, the reduced grid, 2 samples",
       .filtered = "<case>/<coordinates>/<id>",
       .repetitions = std::to_string(usual_repetitions)});
  if (!bench::read(parser, line.arguments)) return bench::success;
  measure_all(options, line);
  return bench::success;
}

}  // namespace desmo::accuracy
