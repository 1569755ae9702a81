// desmo_bench: every case × size × formulation as a Google Benchmark, verified before it is timed.

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/suite/cell.h"
#include "bench/suite/environment.h"
#include "bench/suite/options.h"
#include "bench/suite/record.h"
#include "formulations/algebra/blas.h"

namespace desmo::suite {

namespace {

using Cells = std::vector<std::unique_ptr<Cell>>;

/// Keeps the raw samples of every cell beside what the console shows.
class CollectingReporter final : public benchmark::ConsoleReporter {
 public:
  explicit CollectingReporter(const std::vector<Cell*>& cells) : ConsoleReporter(OO_Tabular) {
    for (Cell* cell : cells) cells_[cell->name()] = cell;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      const auto it = cells_.find(run.run_name.function_name);
      if (it != cells_.end() && run.run_type == Run::RT_Iteration && !run.error_occurred)
        it->second->cpu_seconds.push_back(run.cpu_accumulated_time /
                                          static_cast<double>(run.iterations));
      if (run.error_occurred || run.repetitions == 1 || run.aggregate_name == "median" ||
          run.aggregate_name == "cv")
        shown.push_back(run);
      if (run.error_occurred) break;  // the other repetitions say the same
    }
    ConsoleReporter::ReportRuns(shown);
  }

 private:
  std::map<std::string, Cell*> cells_;
};

void run_cell(benchmark::State& state, Cell& cell) {
  if (cell.state != Cell::State::verified) return state.SkipWithError(cell.message.c_str());
  for (auto _ : state) {
    if (!cell.analyse().ok()) return state.SkipWithError(cell.message.c_str());
  }
  state.counters["coordinates"] = cell.coordinates;
  state.counters["groups"] = cell.groups;
  state.counters["iterations/step"] = cell.iterations_per_step;
  state.counters["residual"] = cell.residual;
}

/// Cells whose benchmark the filter selects. Google Benchmark offers no question for that before
/// registration, so they are registered once for the question and anew for the measurement.
std::vector<Cell*> selected(const Cells& cells) {
  struct Names final : benchmark::BenchmarkReporter {
    std::vector<std::string> found;
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
      for (const Run& run : runs) found.push_back(run.run_name.function_name);
    }
  } names;
  for (const auto& cell : cells)
    benchmark::RegisterBenchmark(cell->name().c_str(), [](benchmark::State& state) {
      for (auto _ : state) {
      }
    });
  std::vector<Cell*> result;
  benchmark::RunSpecifiedBenchmarks(&names);
  benchmark::ClearRegisteredBenchmarks();
  for (const auto& cell : cells)
    if (std::ranges::find(names.found, cell->name()) != names.found.end())
      result.push_back(cell.get());
  return result;
}

std::string command_line(int argc, char** argv) {
  std::string command = std::filesystem::path(argv[0]).filename().string();
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  return command;
}

bool is_listing(std::string_view argument) {
  return argument.starts_with("--benchmark_list_tests") && !argument.ends_with("=false");
}

/// Freed memory stays with the process. Otherwise what UMFPACK frees after each factorisation goes
/// back to the system beyond some size, its page faults are timed, and whether that happens depends
/// on what ran before.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 28);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
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
  std::string repetitions = "--benchmark_repetitions=5";
  std::string least_time = "--benchmark_min_time=1e-6";
  std::string help = "--help";
  arguments.insert(arguments.begin() + 1,
                   {interleave.data(), repetitions.data(), least_time.data()});
  if (options.help) arguments.push_back(help.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 64;
  set_blas_threads(1);  // the clock is the thread's own

  Run record{utc_now(), command_line(argc, argv), load_averages(), {}};
  const Cells all = make_cells(options);
  const std::vector<Cell*> cells = selected(all);
  if (std::ranges::any_of(arguments, is_listing)) return 0;
  if (cells.empty()) return 64;  // Google Benchmark has said that nothing matches
  std::optional<RecordFile> file;
  if (!options.record.empty()) file.emplace(options.record);

  ReferenceCache references;
  for (Cell* cell : cells) {
    cell->verify(references);
    cell->profile();
    if (cell->state == Cell::State::not_run || cell->state == Cell::State::failed)
      std::cerr << cell->name() << ": " << cell->message << '\n';
    if (cell->state == Cell::State::not_run) continue;
    benchmark::RegisterBenchmark(cell->name().c_str(), &run_cell, std::ref(*cell))
        ->Unit(benchmark::kMillisecond);
  }
  CollectingReporter reporter(cells);
  if (!std::ranges::all_of(cells, &Cell::is_not_run)) benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  record.load_after = load_averages();
  if (file) file->write(record, cells);
  return std::ranges::any_of(cells, &Cell::is_failed) ? 1 : 0;
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
