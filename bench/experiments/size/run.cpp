// desmo_bench size: how the time of a step grows with the size of a mechanism, and where solving
// all of it at once costs the same with dense and with sparse matrices.
#include <CLI/CLI.hpp>
#include <iostream>
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

namespace desmo::size {

namespace {

using bench::ProblemCandidate;
using Json = nlohmann::ordered_json;

constexpr int usual_repetitions = 5;
constexpr double min_seconds = 0.02;       // of a sample
constexpr double long_motion_seconds = 1;  // a motion that takes longer has two samples only

double work_of(const SizeSeries& series) {
  return series.size * static_cast<double>(series.ids.size());
}

/// Returns a candidate's entry in `growth` or `break_even` of the record
/// (results/record.schema.json).
Json entry_json(const SizeSeries& series, const bench::Problem& problem,
                const ProblemCandidate& candidate) {
  const Model& m = problem.plan.model;
  Json j = {{"case", series.definition->name},       {"coordinates", m.coordinates()},
            {"unknowns", bench::moving_unknowns(m)}, {"id", candidate.id()},
            {"step_seconds", problem.grid.step},     {"instants", problem.grid.instants},
            {"tolerance", problem.tolerance}};
  j["status"] = candidate.is_timed() ? "ok" : "failed";
  if (!candidate.is_timed()) {
    j["message"] = candidate.message().empty() ? "not timed" : candidate.message();
    return j;
  }
  j["checked_against"] = problem.checked_against;
  j["verification"] = bench::errors_json(candidate.verifying_run().errors);
  j["iterations_per_step"] = candidate.verifying_run().iterations_per_step;
  j["residual"] = candidate.verifying_run().residual;
  // q, q̇ and q̈
  j["state_bytes"] = 3 * sizeof(double) * static_cast<std::size_t>(m.state_size());
  if (candidate.verifying_run().bytes > 0) j["bytes"] = candidate.verifying_run().bytes;
  j["time_per_step"] = bench::rounded_time_json(candidate.verified()->seconds());
  return j;
}

/// Verifies every formulation, then times them in turn, so that whatever slows the machine down for
/// a while meets them all. Names what is wrong, and returns whether nothing is.
bool measure(const SizeSeries& series, int repetitions, Json& list) {
  const bench::Problem problem = series.problem();
  bench::ReferenceCache references;
  std::list<ProblemCandidate> candidates;
  for (const std::string_view id : series.ids)
    candidates.emplace_back(problem, id, Settings{.tolerance = problem.tolerance})
        .verify(references);
  for (int round = 0; round < repetitions; ++round)
    for (ProblemCandidate& candidate : candidates)
      if (!candidate.is_sampled(long_motion_seconds)) candidate.sample_afresh(min_seconds);
  bool right = true;
  for (const ProblemCandidate& candidate : candidates) {
    list.push_back(entry_json(series, problem, candidate));
    if (candidate.is_timed()) continue;
    right = false;
    std::cerr << name_of(series.question) << '/' << candidate.name() << ": " << candidate.message()
              << '\n';
  }
  return right;
}

}  // namespace

int run(const bench::CommandLine& line) {
  bench::CommonOptions options;
  CLI::App parser("desmo_bench size: how time grows with the size of a mechanism.");
  bench::add_common(parser, options,
                    {.quick = "small sizes only",
                     .filtered = "<question>/<case>/<size>/<id>, such as "
                                 "growth/four_bar/114/group_symbolic_inlined",
                     .repetitions = std::to_string(usual_repetitions)});
  if (!bench::read(parser, line.arguments)) return 0;

  const std::vector<SizeSeries> all =
      matching(options.quick ? quick_series() : all_series(), std::regex(options.filter));
  if (all.empty()) throw std::invalid_argument("nothing matches " + options.filter);
  bench::RecordWriter recording = begin_record(options, line);
  const int repetitions = options.repetitions > 0 ? options.repetitions : usual_repetitions;
  double work = 0;
  for (const SizeSeries& series : all) work += work_of(series);
  bench::Progress progress("sizes", work);
  Json lists;
  bool right = true;
  for (const SizeSeries& series : all) {
    right &= measure(series, repetitions, lists[std::string(name_of(series.question))]);
    progress.done(work_of(series));
  }
  recording.write(all.front().definition->with_units(1).grid, lists);
  return right ? 0 : 1;
}

}  // namespace desmo::size
