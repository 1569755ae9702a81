// desmo_bench paper: every case × size × formulation, and every request, as a Google Benchmark,
// verified before it is timed.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/measurement.h"
#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/peer_candidate.h"
#include "bench/experiments/paper/request.h"
#include "bench/kit/process/own_process.h"
#include "formulations/variants.h"

namespace desmo::paper {

using namespace bench;

using Json = nlohmann::ordered_json;

namespace {

/// Returns the number of repetitions as Google Benchmark reads it: the last flag counts. Returns
/// nothing where there is no such flag.
std::optional<int> repetitions_of(const std::vector<std::string>& arguments) {
  constexpr std::string_view flag = "--benchmark_repetitions=";
  std::optional<int> repetitions;
  for (const std::string& a : arguments)
    if (a.starts_with(flag)) repetitions = std::max(1, std::atoi(a.c_str() + flag.size()));
  return repetitions;
}

/// Returns the candidates that Google Benchmark's filter selects: one that begins with "-" selects
/// all others.
std::vector<Candidate*> selected(const std::vector<std::unique_ptr<Candidate>>& all) {
  std::string filter = benchmark::GetBenchmarkFilter();
  const bool others = filter.starts_with('-');
  if (others) filter.erase(0, 1);
  const std::regex expression(filter == "all" ? "" : filter);
  std::vector<Candidate*> result;
  for (const auto& candidate : all)
    if (std::regex_search(candidate->name(), expression) != others)
      result.push_back(candidate.get());
  return result;
}

/// Throws std::invalid_argument where time grids differ: a record has one.
void require_one_grid(const std::vector<std::unique_ptr<Candidate>>& all) {
  const TimeGrid& first = all.front()->grid();
  for (const auto& candidate : all)
    if (candidate->grid().step != first.step || candidate->grid().instants != first.instants)
      throw std::invalid_argument(
          "the motions differ in step or duration: give --step and --duration");
}

/// Candidates that are compared with each other: all of one case and size, as a rule.
struct ComparedCandidates {
  std::string name;  ///< "truck_suspension/558"
  std::vector<Candidate*> candidates;
};

/// Returns all candidates by case and size. together: as one entry instead.
std::vector<ComparedCandidates> compared_candidates(const std::vector<Candidate*>& all,
                                                    bool together) {
  if (together) return {{"desmo_bench", all}};
  std::vector<ComparedCandidates> compared;
  for (Candidate* candidate : all) {
    const std::string name = candidate->name();
    const std::string of = name.substr(0, name.find('/', name.find('/') + 1));
    auto it = std::ranges::find(compared, of, &ComparedCandidates::name);
    if (it == compared.end()) it = compared.insert(it, {of, {}});
    it->candidates.push_back(candidate);
  }
  return compared;
}

/// Returns whether Google Benchmark is to write a file. It would write it anew in every process.
bool has_output_file(const std::vector<std::string>& arguments) {
  return std::ranges::any_of(arguments, [](std::string_view a) {
    return a.starts_with("--benchmark_out=") && !a.ends_with('=');
  });
}

bool is_listing(std::string_view argument) {
  return argument.starts_with("--benchmark_list_tests") && !argument.ends_with("=false");
}

/// Gives Google Benchmark its flags. Returns false where there is one that it does not know.
bool initialise(std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  return !benchmark::ReportUnrecognizedArguments(count, pointers.data());
}

/// Returns every candidate, each name once: a formulation that was asked for may also be measured
/// against a peer.
std::vector<std::unique_ptr<Candidate>> all_candidates(const Options& options) {
  std::vector<std::unique_ptr<Candidate>> all;
  std::set<std::string> names;
  const auto add = [&](auto candidates) {
    for (auto& candidate : candidates)
      if (names.insert(candidate->name()).second) all.push_back(std::move(candidate));
  };
  if (!options.scenes.empty()) {
    add(make_scene_candidates(options));
    return all;
  }
  add(make_case_candidates(options));
  add(make_request_candidates(options));
  add(make_candidates_for_peers(options));
  add(make_peer_candidates(options));
  return all;
}

/// Measures the entries of `all` one after the other, each in a process of its own. Joins what
/// measure() returns of them.
Json measure_all(const std::vector<ComparedCandidates>& all, std::size_t candidates,
                 Console console) {
  Json result = {{"failed", false}, {"lists", Json::object()}};
  Progress progress("benchmarks", work_of_candidate * static_cast<double>(candidates));
  for (const ComparedCandidates& compared : all) {
    const Json measured = in_own_process(
        compared.name, [&] { return measure(compared.candidates, console, progress); });
    console.is_first = false;
    progress.add_done(work_of_candidate * static_cast<double>(compared.candidates.size()));
    if (measured["failed"]) result["failed"] = true;
    for (const auto& [name, list] : measured["lists"].items()) {
      Json& all_of_it = result["lists"].emplace(name, Json::array()).first.value();
      all_of_it.insert(all_of_it.end(), list.begin(), list.end());
    }
  }
  return result;
}

}  // namespace

bench::ExitCode run(const bench::CommandLine& line) {
  std::vector<std::string> arguments = line.arguments;
  for (const std::string_view a : arguments)
    if (a.starts_with("--benchmark_report_aggregates_only") || a.starts_with("--benchmark_format"))
      throw std::invalid_argument(std::string(a) +
                                  ": not here, every sample is recorded; see --record and "
                                  "--benchmark_out");
  const Options options = take_options(arguments);

  // Defaults first, so that the user's flags win. An iteration is a whole analysis. With so short a
  // minimum time, a repetition is one iteration.
  arguments.insert(arguments.begin(), {line.program, "--benchmark_enable_random_interleaving=true",
                                       "--benchmark_min_time=1e-6"});
  if (options.help) arguments.push_back("--help");
  // Before Google Benchmark takes its flags away.
  const Console console{.repetitions = repetitions_of(arguments),
                        .has_table = options.table || options.record.empty()};
  const bool listing = std::ranges::any_of(arguments, is_listing),
             together = has_output_file(arguments);
  if (!initialise(arguments)) return bench::usage_error;
  for (const std::string& note : faulty_libraries()) std::cerr << "desmo_bench: " << note << '\n';

  const std::vector<std::unique_ptr<Candidate>> all = all_candidates(options);
  require_one_grid(all);
  const std::vector<Candidate*> chosen = selected(all);
  if (chosen.empty()) throw std::invalid_argument("no benchmark matches the filter");
  if (listing) {
    for (const Candidate* candidate : chosen) std::cout << candidate->name() << '\n';
    return bench::success;
  }
  std::optional<RecordWriter> recording;
  if (!options.record.empty())
    recording.emplace(options.record, line.text, line.experiment);
  else
    std::cerr << "desmo_bench: without --record nothing of this will be kept\n";
  const Json measured = measure_all(compared_candidates(chosen, together), chosen.size(), console);
  benchmark::Shutdown();
  if (recording)
    recording->write(chosen.front()->grid(), measured["lists"],
                     static_cast<int>(TimingWindows(chosen.front()->grid().instants).count()));
  return measured["failed"] ? bench::not_solved : bench::success;
}

}  // namespace desmo::paper
