// desmo_bench: every case × size × formulation, and every request, as a Google Benchmark, verified
// before it is timed.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/suite/cell.h"
#include "bench/suite/environment.h"
#include "bench/suite/kept_memory.h"
#include "bench/suite/new_file.h"
#include "bench/suite/options.h"
#include "bench/suite/peer_cell.h"
#include "bench/suite/record.h"
#include "bench/suite/request.h"
#include "bench/suite/run_progress.h"
#include "formulations/algebra/blas.h"

namespace desmo::suite {

namespace {

/// As the console is to show it: the time given to Google Benchmark by hand is CPU time, and what
/// it finds itself is that of a thread that waits.
benchmark::BenchmarkReporter::Run shown_as_cpu_time(benchmark::BenchmarkReporter::Run run) {
  run.run_name.time_type.clear();
  run.run_name.repetitions.clear();
  run.cpu_accumulated_time = run.real_accumulated_time;
  return run;
}

/// Keeps the raw samples of everything timed beside what the console shows.
class CollectingReporter final : public benchmark::ConsoleReporter {
 public:
  CollectingReporter(const std::vector<Timed*>& all, RunProgress& progress)
      : ConsoleReporter(OO_Tabular), progress_(progress) {
    for (Timed* timed : all) timed_[timed->name()] = timed;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      const auto it = timed_.find(run.run_name.function_name);
      if (it != timed_.end() && run.run_type == Run::RT_Iteration && !run.error_occurred)
        it->second->cpu_seconds.push_back(run.real_accumulated_time /
                                          static_cast<double>(run.iterations));
      if (run.error_occurred || run.repetitions == 1 || run.aggregate_name == "median" ||
          run.aggregate_name == "cv")
        shown.push_back(shown_as_cpu_time(run));
      if (run.error_occurred) break;  // the other repetitions say the same
    }
    progress_.clear();
    ConsoleReporter::ReportRuns(shown);
  }

 private:
  RunProgress& progress_;
  std::map<std::string, Timed*> timed_;
};

/// One repetition.
void run_timed(benchmark::State& state, Timed& timed, RunProgress& progress) {
  if (timed.state != Timed::State::verified) return state.SkipWithError(timed.message.c_str());
  for (auto _ : state) {
    state.SetIterationTime(timed.time_afresh());
    if (timed.is_failed()) return state.SkipWithError(timed.message.c_str());
  }
  for (const auto& [name, value] : timed.counters()) state.counters[name] = value;
  progress.repeated(timed);
}

/// As Google Benchmark reads it: the last one counts. Nothing where the user leaves it to us.
std::optional<int> repetitions_of(const std::vector<char*>& arguments) {
  constexpr std::string_view flag = "--benchmark_repetitions=";
  std::optional<int> repetitions;
  for (const std::string_view a : arguments)
    if (a.starts_with(flag)) repetitions = std::max(1, std::atoi(a.data() + flag.size()));
  return repetitions;
}

/// As many as take long enough, together, that something of them is undisturbed: a core may be slow
/// for seconds. What takes long itself needs few.
int worth_repeating(const Timed& timed) {
  constexpr double seconds = 2.5;
  constexpr int fewest = 3, most = 20;
  const double needed = std::ceil(seconds / std::max(timed.analysis_seconds, 1e-9));
  return static_cast<int>(std::clamp<double>(needed, fewest, most));
}

/// Those whose benchmark the filter selects. Google Benchmark offers no question for that before
/// registration, so they are registered once for the question and anew for the measurement.
std::vector<Timed*> selected(const std::vector<Timed*>& all) {
  struct Names final : benchmark::BenchmarkReporter {
    std::set<std::string> found;
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
      for (const Run& run : runs) found.insert(run.run_name.function_name);
    }
  } names;
  for (const Timed* timed : all)
    benchmark::RegisterBenchmark(timed->name().c_str(), [](benchmark::State& state) {
      for (auto _ : state) {
      }
    });
  std::vector<Timed*> result;
  benchmark::RunSpecifiedBenchmarks(&names);
  benchmark::ClearRegisteredBenchmarks();
  for (Timed* timed : all)
    if (names.found.contains(timed->name())) result.push_back(timed);
  return result;
}

template <class Kind>
void append(std::vector<Timed*>& all, const std::vector<std::unique_ptr<Kind>>& some) {
  for (const auto& timed : some) all.push_back(timed.get());
}

/// A record has one time grid.
void require_one_grid(const std::vector<Timed*>& all) {
  const TimeGrid& first = all.front()->grid;
  for (const Timed* timed : all)
    if (timed->grid.step != first.step || timed->grid.instants != first.instants)
      throw std::invalid_argument(
          "the cases differ in step or duration: give --step and --duration");
}

bool is_listing(std::string_view argument) {
  return argument.starts_with("--benchmark_list_tests") && !argument.ends_with("=false");
}

int run(int argc, char** argv) {
  keep_freed_memory();
  std::vector<char*> arguments(argv, argv + argc);
  for (const std::string_view a : arguments)
    if (a.starts_with("--benchmark_report_aggregates_only") || a.starts_with("--benchmark_format"))
      throw std::invalid_argument(std::string(a) +
                                  ": not here, every sample is recorded; see --record and "
                                  "--benchmark_out");
  const Options options = take_options(arguments);
  if (options.help) std::cout << usage;

  // Defaults first, so that the user's flags win. An iteration is a whole analysis, and a
  // repetition is one iteration: the least time is met by the first.
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::string least_time = "--benchmark_min_time=1e-6";
  std::string help = "--help";
  arguments.insert(arguments.begin() + 1, {interleave.data(), least_time.data()});
  if (options.help) arguments.push_back(help.data());
  const std::optional<int> asked_repetitions = repetitions_of(arguments);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 64;
  set_blas_threads(1);  // the clock is the thread's own

  Run record{utc_now(), command_line(argc, argv), load_averages(), {}};
  const auto cells = make_cells(options);
  const auto requests = make_requests(options);
  const auto beside_peers = make_cells_beside_peers(options);
  const auto peers = make_peer_cells(options);
  std::vector<Timed*> all;
  append(all, cells);
  append(all, requests);
  append(all, beside_peers);
  append(all, peers);
  require_one_grid(all);
  const std::vector<Timed*> chosen = selected(all);
  if (std::ranges::any_of(arguments, is_listing)) return 0;
  if (chosen.empty()) return 64;  // Google Benchmark has said that nothing matches
  std::optional<NewFile> file;
  if (!options.record.empty()) file.emplace(options.record);

  ReferenceCache references;
  RunProgress progress(chosen);
  for (Timed* timed : chosen) {
    timed->verify(references);
    timed->profile();
    const int repetitions = asked_repetitions.value_or(worth_repeating(*timed));
    progress.verified(*timed, repetitions);
    if (timed->is_not_run() || timed->is_failed()) {
      progress.clear();
      std::cerr << timed->name() << ": " << timed->message << '\n';
    }
    if (timed->is_not_run()) continue;
    auto* const registered = benchmark::RegisterBenchmark(timed->name().c_str(), &run_timed,
                                                          std::ref(*timed), std::ref(progress));
    registered->Unit(benchmark::kMillisecond)->UseManualTime();
    if (!asked_repetitions) registered->Repetitions(repetitions);
  }
  progress.timing();
  CollectingReporter reporter(chosen, progress);
  if (!std::ranges::all_of(chosen, &Timed::is_not_run))
    benchmark::RunSpecifiedBenchmarks(&reporter, ".");  // those chosen, whatever the filter
  benchmark::Shutdown();
  record.load_after = load_averages();
  if (file) file->write(record_text(record, chosen));
  return std::ranges::any_of(chosen, &Timed::is_failed) ? 1 : 0;
}

}  // namespace

}  // namespace desmo::suite

int main(int argc, char** argv) {
  try {
    return desmo::suite::run(argc, argv);
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_bench: " << e.what() << '\n';
    return 64;
  } catch (const std::exception& e) {
    std::cerr << "desmo_bench: " << e.what() << '\n';
    return 74;
  }
}
