// desmo_bench size: how the time of a step grows with the size of a mechanism, and where solving
// all of it at once costs the same with dense and with sparse matrices.
#include <CLI/CLI.hpp>
#include <list>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/experiments/size/series.h"
#include "bench/kit/formulation_candidate.h"
#include "bench/kit/problem.h"
#include "bench/kit/process/progress.h"
#include "bench/kit/record/timed_in_turn.h"

namespace desmo::size {

namespace {

using bench::FormulationCandidate;
using Json = nlohmann::ordered_json;

constexpr int usual_repetitions = 5;

double work_of(const SizeSeries& series) {
  return series.size * static_cast<double>(series.ids.size());
}

/// Verifies and times a series, and adds its entries. Returns whether nothing is wrong.
bool measure(const SizeSeries& series, int repetitions, Json& list) {
  const bench::Problem problem = series.problem();
  std::list<FormulationCandidate> candidates;
  for (const std::string_view id : series.ids)
    candidates.emplace_back(problem, id, Settings{.tolerance = problem.tolerance});
  const bool right = bench::time_in_turn(candidates, repetitions, name_of(series.question));
  for (const FormulationCandidate& candidate : candidates) {
    Json entry = bench::timed_entry(candidate);
    entry["unknowns"] = bench::moving_unknowns(problem.plan.model);
    list.push_back(std::move(entry));
  }
  return right;
}

}  // namespace

bench::ExitCode run(const bench::CommandLine& line) {
  bench::CommonOptions options;
  CLI::App parser("desmo_bench size: how time grows with the size of a mechanism.");
  bench::add_common(parser, options,
                    {.quick = "small sizes only",
                     .filtered = "<question>/<case>/<size>/<id>, such as "
                                 "growth/four_bar/114/group_symbolic_inlined",
                     .repetitions = std::to_string(usual_repetitions)});
  if (!bench::read(parser, line.arguments)) return bench::success;

  const std::vector<SizeSeries> all = make_series(options.quick, std::regex(options.filter));
  if (all.empty()) throw std::invalid_argument("nothing matches " + options.filter);
  bench::RecordWriter recording = begin_record(options, line);
  const int repetitions = options.samples(usual_repetitions, usual_repetitions);
  double work = 0;
  for (const SizeSeries& series : all) work += work_of(series);
  bench::Progress progress("sizes", work);
  Json lists;
  bool right = true;
  for (const SizeSeries& series : all) {
    right &= measure(series, repetitions, lists[std::string(name_of(series.question))]);
    progress.add_done(work_of(series));
  }
  recording.write(all.front().definition->with_units(1).grid, lists);
  return right ? bench::success : bench::not_solved;
}

}  // namespace desmo::size
