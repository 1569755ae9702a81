// desmo_precision: time against error, for formulations and the settings that trade one for the
// other.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bench/precision/record.h"
#include "bench/suite/environment.h"
#include "bench/suite/environment_json.h"
#include "bench/suite/kept_memory.h"
#include "bench/suite/new_file.h"
#include "bench/suite/progress.h"
#include "formulations/algebra/blas.h"
#include "formulations/modelling/model.h"

namespace desmo::precision {

namespace {

constexpr int compared_instants = 21;
constexpr double least_seconds = 0.01;  // of a sample

struct Options {
  std::string record, command;
  int repetitions = 5;
  bool quick = false;
};

/// Compares every configuration, then times them in turn, so that whatever slows the machine down
/// for a while meets them all.
std::vector<Trial> measure(const Series& series, const Problem& problem, int repetitions) {
  std::vector<Trial> trials;
  for (const Configuration& c : series.configurations) trials.emplace_back(problem, c);
  for (Trial& trial : trials) trial.compare();
  for (int round = 0; round < repetitions; ++round)
    for (Trial& trial : trials) trial.time(least_seconds);
  return trials;
}

/// The document without its points.
nlohmann::ordered_json document(const suite::Run& run, const TimeGrid& grid) {
  nlohmann::ordered_json j = {{"schema", "desmo-results"}, {"version", suite::schema_version}};
  j["record"] = suite::environment_json(run, grid);
  for (const char* list : {"cells", "floors", "precision"})
    j[list] = nlohmann::ordered_json::array();
  return j;
}

void run(const Options& options) {
  suite::keep_freed_memory();
  set_blas_threads(1);  // the clock is the thread's own
  suite::NewFile file(options.record);
  suite::Run run{suite::utc_now(), options.command, suite::load_averages(), {}};
  const std::vector<Series> all = options.quick ? quick_series() : all_series();
  nlohmann::ordered_json floors = nlohmann::ordered_json::array(), points = floors;
  TimeGrid usual;
  suite::Progress progress("series of configurations", static_cast<int>(all.size()));
  for (const Series& series : all) {
    const Mechanism whole = make_mechanism(describe(*series.definition, series.coordinates));
    const TimeGrid grid = time_grid(series.step * (series.instants - 1), series.step);
    if (&series == &all.front()) usual = grid;
    const Problem problem = make_problem(make_plan(whole, {}), grid, compared_instants);
    floors.push_back(floor_json(series, problem));
    for (const Trial& trial : measure(series, problem, options.repetitions))
      points.push_back(point_json(series, trial));
    progress.one_done();
  }
  run.load_after = suite::load_averages();
  nlohmann::ordered_json j = document(run, usual);
  j["floors"] = std::move(floors);
  j["precision"] = std::move(points);
  file.write(j.dump(1) + "\n");
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
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 64;
  }
  for (int i = 0; i < argc; ++i) options.command += (i == 0 ? "" : " ") + std::string(argv[i]);
  options.command.erase(0, options.command.find_last_of('/', options.command.find(' ')) + 1);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "desmo_precision: " << error.what() << '\n';
    return 74;
  }
}
