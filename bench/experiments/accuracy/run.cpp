// desmo_bench accuracy: time against error, for formulations and the settings that trade one for
// the other.
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/accuracy/drift.h"
#include "bench/experiments/accuracy/record.h"
#include "bench/experiments/accuracy/tuning_validation.h"
#include "bench/kit/common_options.h"
#include "bench/kit/memory/kept_memory.h"
#include "bench/kit/process/progress.h"
#include "bench/kit/record/recording.h"
#include "formulations/algebra/blas.h"
#include "formulations/modelling/modelling.h"

namespace desmo::accuracy {

namespace {

constexpr int compared_instants = 21;
constexpr int usual_repetitions = 5;
constexpr double min_seconds = 0.01;  // of a sample
constexpr double dear_seconds = 0.3;  // a motion that takes longer has two samples only

struct Options : bench::CommonOptions {
  bool validates_tuning = false;
  std::vector<std::string> mechanisms;
  bool measures_drift = false;
};

bool is_sampled(const Trial& trial, const Series& series) {
  return trial.seconds_per_step.size() >= 2 && trial.min_seconds() * series.instants > dear_seconds;
}

/// Compares every configuration, then times them in turn, so that whatever slows the machine down
/// for a while meets them all.
std::vector<Trial> measure(const Series& series, const Problem& problem, int repetitions,
                           bench::Progress& progress) {
  std::vector<Trial> trials;
  for (const Configuration& c : series.configurations) trials.emplace_back(problem, c);
  for (Trial& trial : trials) {
    trial.compare();
    progress.one_done();
  }
  for (int round = 0; round < repetitions; ++round)
    for (Trial& trial : trials) {
      if (!is_sampled(trial, series)) trial.time(min_seconds);
      progress.one_done();
    }
  return trials;
}

int comparisons_and_samples(const std::vector<Series>& all, int repetitions) {
  std::size_t count = 0;
  for (const Series& series : all) count += series.configurations.size();
  return static_cast<int>(count) * (1 + repetitions);
}

void measure_all(const Options& options, const std::string& command) {
  const std::vector<Series> all =
      matching(options.quick ? quick_series() : all_series(), std::regex(options.filter));
  if (all.empty()) throw std::invalid_argument("no configuration matches " + options.filter);
  bench::Recording recording(options.record, command);
  nlohmann::ordered_json lists = {{"floors", nlohmann::ordered_json::array()},
                                  {"points", nlohmann::ordered_json::array()}};
  TimeGrid usual;
  const int repetitions = options.repetitions > 0 ? options.repetitions : usual_repetitions;
  bench::Progress progress("comparisons and samples", comparisons_and_samples(all, repetitions));
  for (const Series& series : all) {
    const Model whole = make_model(describe(*series.definition, series.coordinates));
    const TimeGrid grid = time_grid(series.step * (series.instants - 1), series.step);
    if (&series == &all.front()) usual = grid;
    const Problem problem = make_problem(make_plan(whole, {}), grid, compared_instants);
    lists["floors"].push_back(floor_json(series, problem));
    for (const Trial& trial : measure(series, problem, repetitions, progress))
      lists["points"].push_back(point_json(series, trial));
  }
  recording.write(usual, lists);
}

/// Throws std::invalid_argument for options that have nothing to do with what is measured.
void require_consistent(const Options& o, const std::vector<std::string>& words) {
  const bool selects = o.quick || o.repetitions > 0 || !o.filter.empty();
  if (!o.measures_drift && !words.empty())
    throw std::invalid_argument("unknown argument '" + words.front() + "'");
  if (o.measures_drift && (selects || o.validates_tuning || !o.record.empty()))
    throw std::invalid_argument("--drift prints a table; it goes with no other option");
  if (o.validates_tuning && selects)
    throw std::invalid_argument("--validate-tuning goes with --record and --mechanism only");
  if (!o.validates_tuning && !o.mechanisms.empty())
    throw std::invalid_argument("--mechanism belongs to --validate-tuning");
}

int run(const bench::CommandLine& line) {
  Options options;
  bench::OptionTable table(
      "desmo_bench accuracy: time against error of formulations and their settings.\n"
      "desmo_bench accuracy --validate-tuning [--mechanism NAME]...\n"
      "desmo_bench accuracy --drift MECHANISM ID [STEPS [TOLERANCE]]");
  bench::add_common(table, options,
                    {.quick = "the smallest sizes only, with few settings",
                     .filtered = "<case>/<coordinates>/<id>",
                     .repetitions = std::to_string(usual_repetitions)});
  table.flag("--validate-tuning", options.validates_tuning,
             "Instead: is the error held that desmo tune promises,\n"
             "and how much slower is its choice than the best?");
  table.texts("--mechanism", "NAME", options.mechanisms,
              "Validate with this mechanism only; more than once where wanted");
  table.flag("--drift", options.measures_drift,
             "Instead: does the error grow in a long run (1000000 steps)?\n"
             "MECHANISM is <case>/<coordinates> or one of the library");
  std::vector<std::string> words;
  if (!bench::read_options(table, line, &words)) return 0;
  require_consistent(options, words);
  bench::keep_freed_memory();
  set_blas_threads(1);  // the clock is the thread's own
  if (options.measures_drift) return print_drift(words) ? 0 : 1;
  if (options.validates_tuning)
    validate_tuning(options.record, line.text, options.mechanisms);
  else
    measure_all(options, line.text);
  return 0;
}

}  // namespace

}  // namespace desmo::accuracy

int desmo::bench::run_accuracy(const CommandLine& line) { return desmo::accuracy::run(line); }
