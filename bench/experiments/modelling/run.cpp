// desmo_bench modelling: the paper's comparison in each kind of coordinates.
#include <CLI/CLI.hpp>
#include <list>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/experiments/modelling/problems.h"
#include "bench/kit/candidate_name.h"
#include "bench/kit/formulation_candidate.h"
#include "bench/kit/process/progress.h"
#include "bench/kit/record/timed_in_turn.h"
#include "cases/generators/cases.h"

namespace desmo::modelling {

namespace {

using bench::FormulationCandidate;
using Json = nlohmann::ordered_json;

constexpr int usual_repetitions = 5, quick_repetitions = 3;
/// Number of instants, from the beginning of the paper's motion. Compared with them, the assembly
/// costs little; the slowest formulations take a second.
constexpr int instants = 201;

/// A case at a size, with the formulations that were asked for.
struct Comparison {
  const Case* definition;
  int coordinates;
  std::vector<std::pair<Modelling, std::string>> ids;
};

/// Returns the instants at which a case is compared.
TimeGrid grid_of(const Case& definition) {
  TimeGrid grid = definition.with_units(1).grid;
  grid.instants = instants;
  return grid;
}

std::vector<Comparison> comparisons(const bench::CommonOptions& options) {
  const std::regex wanted(options.filter);
  std::vector<Comparison> all;
  for (const Case& c : cases())
    for (const int n : c.sizes) {
      if (options.quick && n != c.sizes.front()) continue;
      Comparison one{&c, n, {}};
      for (const std::string_view natural : compared_ids)
        for (const Modelling kind : modelling_kinds)
          for (const Frames frames : {Frames::linearised, Frames::exact}) {
            const std::string id = id_in(natural, kind, frames),
                              name = bench::CandidateName{std::string(c.name), n, id}.text();
            if (!id.empty() && std::regex_search(name, wanted)) one.ids.emplace_back(kind, id);
          }
      if (!one.ids.empty()) all.push_back(std::move(one));
    }
  return all;
}

/// Verifies and times the formulations, and adds an entry of each to a list of the record. Returns
/// whether all were timed.
bool measure(const Comparison& comparison, int repetitions, Json& list) {
  const Scene scene = make_scene(*comparison.definition, comparison.coordinates);
  const TimeGrid grid = grid_of(*comparison.definition);
  const bench::Problem natural = natural_problem(scene, grid);
  std::map<Modelling, bench::Problem> problems;
  std::list<FormulationCandidate> candidates;
  for (const auto& [kind, id] : comparison.ids) {
    if (!problems.contains(kind)) problems.emplace(kind, problem_in(scene, natural, kind));
    candidates.emplace_back(problems.at(kind), id, Settings{});
  }
  const bool right = bench::time_in_turn(candidates, repetitions, "modelling");
  std::map<Modelling, double> conditions;
  for (const auto& [kind, problem] : problems)
    conditions[kind] = condition_at_start(problem.plan.model, grid.time(0));
  for (const FormulationCandidate& candidate : candidates) {
    Json entry = bench::timed_entry(candidate);
    const LinearSystems systems =
        linear_systems(candidate.problem().plan.model, candidate.variant().partition);
    entry["unknowns"] = systems.unknowns;
    if (!candidate.variant().is_generated()) {  // generated code has no matrix
      entry["entries"] = systems.entries;
      entry["condensation"] = systems.condensation;
    }
    entry["condition"] = bench::rounded(conditions.at(candidate.settings().coordinates), 4);
    list.push_back(std::move(entry));
  }
  return right;
}

}  // namespace

bench::ExitCode run(const bench::CommandLine& line) {
  bench::CommonOptions options;
  CLI::App parser("desmo_bench modelling: the paper's comparison in each kind of coordinates.");
  bench::add_common(parser, options,
                    {.quick = "the smallest size of each case, three repetitions",
                     .filtered = "<case>/<coordinates>/<id>, such as "
                                 "truck_suspension/558/group_automatic_klu/coordinates:relative",
                     .repetitions = std::to_string(usual_repetitions)});
  if (!bench::read(parser, line.arguments)) return bench::success;

  const std::vector<Comparison> all = comparisons(options);
  if (all.empty()) throw std::invalid_argument("nothing matches " + options.filter);
  bench::RecordWriter recording = begin_record(options, line);
  const int repetitions = options.samples(usual_repetitions, quick_repetitions);
  double work = 0;
  for (const Comparison& c : all) work += c.coordinates;
  bench::Progress progress("sizes", work);
  Json lists;
  bool right = true;
  for (const Comparison& c : all) {
    right &= measure(c, repetitions, lists["times"]);
    progress.add_done(c.coordinates);
  }
  recording.write(grid_of(*all.front().definition), lists);
  return right ? bench::success : bench::not_solved;
}

}  // namespace desmo::modelling
