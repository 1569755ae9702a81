// desmo_bench paper: every case × size × formulation, and every request, as a Google Benchmark,
// verified before it is timed.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
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
#include "bench/experiments/paper/run_progress.h"
#include "bench/kit/memory/kept_memory.h"
#include "bench/kit/process/own_process.h"
#include "bench/kit/record/environment.h"
#include "bench/kit/record/new_file.h"
#include "bench/kit/record/record.h"
#include "formulations/algebra/blas.h"
#include "formulations/variants.h"

namespace desmo::paper {

using Json = nlohmann::ordered_json;

namespace {

/// As Google Benchmark reads it: the last one counts. Nothing where the user leaves it to us.
std::optional<int> repetitions_of(const std::vector<char*>& arguments) {
  constexpr std::string_view flag = "--benchmark_repetitions=";
  std::optional<int> repetitions;
  for (const std::string_view a : arguments)
    if (a.starts_with(flag)) repetitions = std::max(1, std::atoi(a.data() + flag.size()));
  return repetitions;
}

/// Those whose benchmark the filter selects. Google Benchmark offers no question for that before
/// registration, so they are registered once for the question and anew for the measurement.
std::vector<Candidate*> selected(const std::vector<Candidate*>& all) {
  struct Names final : benchmark::BenchmarkReporter {
    std::set<std::string> found;
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
      for (const Run& run : runs) found.insert(run.run_name.function_name);
    }
  } names;
  for (const Candidate* timed : all)
    benchmark::RegisterBenchmark(timed->name().c_str(), [](benchmark::State& state) {
      for (auto _ : state) {
      }
    });
  std::vector<Candidate*> result;
  benchmark::RunSpecifiedBenchmarks(&names);
  benchmark::ClearRegisteredBenchmarks();
  for (Candidate* timed : all)
    if (names.found.contains(timed->name())) result.push_back(timed);
  return result;
}

/// But for what is there by that name already, such as a formulation that was asked for and also
/// stands beside a rival.
template <class Kind>
void append(std::vector<Candidate*>& all, const std::vector<std::unique_ptr<Kind>>& some) {
  std::set<std::string> names;
  for (const Candidate* timed : all) names.insert(timed->name());
  for (const auto& timed : some)
    if (names.insert(timed->name()).second) all.push_back(timed.get());
}

/// A record has one time grid.
void require_one_grid(const std::vector<Candidate*>& all) {
  const TimeGrid& first = all.front()->grid;
  for (const Candidate* timed : all)
    if (timed->grid.step != first.step || timed->grid.instants != first.instants)
      throw std::invalid_argument(
          "the cases differ in step or duration: give --step and --duration");
}

/// What is compared with each other: all of one case and size.
struct Comparison {
  std::string name;  ///< "truck_suspension/558"
  std::vector<Candidate*> timed;
};

/// together: as one.
std::vector<Comparison> comparisons_of(const std::vector<Candidate*>& all, bool together) {
  if (together) return {{"desmo_bench", all}};
  std::vector<Comparison> comparisons;
  for (Candidate* timed : all) {
    const std::string name = timed->name(), of = name.substr(0, name.find('/', name.find('/') + 1));
    const auto it = std::ranges::find(comparisons, of, &Comparison::name);
    if (it == comparisons.end())
      comparisons.push_back({of, {timed}});
    else
      it->timed.push_back(timed);
  }
  return comparisons;
}

/// Google Benchmark writes it anew in every process.
bool has_output_file(const std::vector<char*>& arguments) {
  return std::ranges::any_of(arguments, [](std::string_view a) {
    return a.starts_with("--benchmark_out=") && !a.ends_with('=');
  });
}

bool is_listing(std::string_view argument) {
  return argument.starts_with("--benchmark_list_tests") && !argument.ends_with("=false");
}

int run(const bench::CommandLine& line) {
  keep_freed_memory();
  std::vector<char*> arguments = line.arguments;
  for (const std::string_view a : arguments)
    if (a.starts_with("--benchmark_report_aggregates_only") || a.starts_with("--benchmark_format"))
      throw std::invalid_argument(std::string(a) +
                                  ": not here, every sample is recorded; see --record and "
                                  "--benchmark_out");
  const Options options = take_options(arguments);
  if (options.help) std::cout << usage();

  // Defaults first, so that the user's flags win. An iteration is a whole analysis, and a
  // repetition is one iteration: the least time is met by the first.
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::string min_time = "--benchmark_min_time=1e-6";
  std::string help = "--help";
  arguments.insert(arguments.begin(), {line.program, interleave.data(), min_time.data()});
  if (options.help) arguments.push_back(help.data());
  // Before Google Benchmark takes its flags away.
  const std::optional<int> asked_repetitions = repetitions_of(arguments);
  const bool listing = std::ranges::any_of(arguments, is_listing),
             together = has_output_file(arguments);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 64;
  set_blas_threads(1);  // the clock is the thread's own
  for (const std::string& note : faulty_libraries()) std::cerr << "desmo_bench: " << note << '\n';

  Run record{utc_now(), line.text, load_averages(), {}};
  const auto cells = make_case_candidates(options);
  const auto requests = make_request_candidates(options);
  const auto beside_peers = make_candidates_for_peers(options);
  const auto peers = make_peer_candidates(options);
  std::vector<Candidate*> all;
  append(all, cells);
  append(all, requests);
  append(all, beside_peers);
  append(all, peers);
  require_one_grid(all);
  const std::vector<Candidate*> chosen = selected(all);
  if (listing) return 0;
  if (chosen.empty()) return 64;  // Google Benchmark has said that nothing matches
  std::optional<NewFile> file;
  if (!options.record.empty()) file.emplace(options.record);

  Json all_lists;
  bool failed = false;
  const auto comparisons = comparisons_of(chosen, together);
  RunProgress progress(static_cast<int>(chosen.size()));
  for (const Comparison& comparison : comparisons) {
    const bool first = &comparison == &comparisons.front();
    const Json measured = in_own_process(comparison.name, [&] {
      return measure(comparison.timed, asked_repetitions, first, progress);
    });
    progress.passed(static_cast<int>(comparison.timed.size()));
    failed = failed || measured["failed"];
    for (const auto& [name, list] : measured["lists"].items()) {
      Json& all_of_it = all_lists.emplace(name, Json::array()).first.value();
      all_of_it.insert(all_of_it.end(), list.begin(), list.end());
    }
  }
  benchmark::Shutdown();
  record.load_after = load_averages();
  if (file)
    file->write(record_text(record, chosen.front()->grid, all_lists,
                            static_cast<int>(chosen.front()->windows.count())));
  return failed ? 1 : 0;
}

}  // namespace

}  // namespace desmo::paper

int desmo::bench::run_paper(const CommandLine& line) { return desmo::paper::run(line); }
