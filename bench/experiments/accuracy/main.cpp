// desmo_precision: time against error, for formulations and the settings that trade one for the
// other.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/experiments/accuracy/record.h"
#include "bench/kit/kept_memory.h"
#include "bench/kit/progress.h"
#include "bench/kit/recording.h"
#include "formulations/algebra/blas.h"
#include "formulations/modelling/model.h"

namespace desmo::precision {

namespace {

constexpr int compared_instants = 21;
constexpr double least_seconds = 0.01;  // of a sample
constexpr double dear_seconds = 0.3;    // a motion that takes longer has two samples only

struct Options {
  std::string record, command, filter;
  int repetitions = 5;
  bool quick = false;
};

bool is_sampled(const Trial& trial, const Series& series) {
  return trial.seconds_per_step.size() >= 2 &&
         trial.least_seconds() * series.instants > dear_seconds;
}

/// Compares every configuration, then times them in turn, so that whatever slows the machine down
/// for a while meets them all.
std::vector<Trial> measure(const Series& series, const Problem& problem, int repetitions,
                           suite::Progress& progress) {
  std::vector<Trial> trials;
  for (const Configuration& c : series.configurations) trials.emplace_back(problem, c);
  for (Trial& trial : trials) {
    trial.compare();
    progress.one_done();
  }
  for (int round = 0; round < repetitions; ++round)
    for (Trial& trial : trials) {
      if (!is_sampled(trial, series)) trial.time(least_seconds);
      progress.one_done();
    }
  return trials;
}

int comparisons_and_samples(const std::vector<Series>& all, int repetitions) {
  std::size_t count = 0;
  for (const Series& series : all) count += series.configurations.size();
  return static_cast<int>(count) * (1 + repetitions);
}

void run(const Options& options) {
  suite::keep_freed_memory();
  set_blas_threads(1);  // the clock is the thread's own
  const std::vector<Series> all =
      matching(options.quick ? quick_series() : all_series(), std::regex(options.filter));
  if (all.empty()) throw std::invalid_argument("no configuration matches " + options.filter);
  suite::Recording recording(options.record, options.command);
  nlohmann::ordered_json lists = {{"floors", nlohmann::ordered_json::array()},
                                  {"points", nlohmann::ordered_json::array()}};
  TimeGrid usual;
  suite::Progress progress("comparisons and samples",
                           comparisons_and_samples(all, options.repetitions));
  for (const Series& series : all) {
    const Mechanism whole = make_mechanism(describe(*series.definition, series.coordinates));
    const TimeGrid grid = time_grid(series.step * (series.instants - 1), series.step);
    if (&series == &all.front()) usual = grid;
    const Problem problem = make_problem(make_plan(whole, {}), grid, compared_instants);
    lists["floors"].push_back(floor_json(series, problem));
    for (const Trial& trial : measure(series, problem, options.repetitions, progress))
      lists["points"].push_back(point_json(series, trial));
  }
  recording.write(usual, lists);
}

}  // namespace

}  // namespace desmo::precision

int main(int argc, char** argv) {
  using namespace desmo::precision;
  CLI::App program{"Time against error of formulations and their settings", "desmo_precision"};
  Options options;
  program.add_option("--record", options.record, "Write the results record to this file")
      ->required();
  program.add_option("--repetitions", options.repetitions, "Samples of each time")
      ->check(CLI::PositiveNumber);
  program.add_flag("--quick", options.quick, "The smallest sizes only, with few settings");
  program.add_option("--filter", options.filter,
                     "Only where this regular expression is found in <case>/<coordinates>/<id>");
  options.command = desmo::suite::command_line(argc, argv);
  return desmo::suite::record_main(program, argc, argv, [&] {
    run(options);
    return true;
  });
}
