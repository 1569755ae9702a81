#include "bench/experiments/paper/measurement.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>

#include "bench/experiments/paper/options.h"
#include "bench/kit/memory.h"

namespace desmo::paper {

using namespace bench;

namespace {

using Json = nlohmann::ordered_json;

/// Returns a run as the console is to show it. Its CPU time is the time that was given to Google
/// Benchmark by hand: what Google Benchmark measures itself is that of a thread that waits. The
/// relative spread of a counter that is always 0 is 0, not NaN.
benchmark::BenchmarkReporter::Run shown_as_cpu_time(benchmark::BenchmarkReporter::Run run) {
  run.run_name.time_type.clear();
  run.run_name.repetitions.clear();
  run.cpu_accumulated_time = run.real_accumulated_time;
  for (auto& [name, counter] : run.counters)
    if (std::isnan(counter.value)) counter.value = 0;
  return run;
}

/// Returns what Google Benchmark says of the machine, without its warning that the library itself
/// was built for debugging, as Debian's is: its code runs between analyses, not within them.
std::string described(const benchmark::BenchmarkReporter::Context& context) {
  std::ostringstream all;
  benchmark::BenchmarkReporter::PrintBasicContext(&all, context);
  std::istringstream lines(all.str());
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (line.find("Library was built as DEBUG") == std::string::npos) kept += line + '\n';
  return kept;
}

/// A reporter that keeps the raw samples of all candidates, and shows a table of them where that is
/// wanted.
class CollectingReporter final : public benchmark::ConsoleReporter {
 public:
  CollectingReporter(const std::vector<Candidate*>& all, const Console& console, Progress& progress)
      : ConsoleReporter(OO_Tabular), console_(console), progress_(progress) {
    for (Candidate* candidate : all) candidates_[candidate->name()] = candidate;
  }

  bool ReportContext(const Context& context) override {
    name_field_width_ = context.name_field_width;
    if (console_.has_table && console_.is_first) GetErrorStream() << described(context);
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      const auto it = candidates_.find(run.run_name.function_name);
      if (it != candidates_.end() && run.run_type == Run::RT_Iteration && !run.error_occurred)
        it->second->add_sample(run.real_accumulated_time / static_cast<double>(run.iterations));
      if (run.error_occurred || run.repetitions == 1 || run.aggregate_name == "median" ||
          run.aggregate_name == "cv")
        shown.push_back(shown_as_cpu_time(run));
      if (run.error_occurred) break;  // the other repetitions say the same
    }
    if (!console_.has_table) return;
    progress_.clear();
    ConsoleReporter::ReportRuns(shown);
  }

 private:
  const Console& console_;
  Progress& progress_;
  std::map<std::string, Candidate*> candidates_;
};

/// Takes one repetition of a candidate. repetitions: number of all its repetitions.
void run_timed(benchmark::State& state, Candidate& candidate, int repetitions, Progress& progress) {
  if (!candidate.is_verified()) return state.SkipWithError(candidate.message().c_str());
  for (auto _ : state) {
    const std::optional<double> seconds = candidate.time_afresh();
    if (!seconds) return state.SkipWithError(candidate.message().c_str());
    state.SetIterationTime(*seconds);
  }
  state.counters["iterations/step"] = candidate.verifying_run().iterations_per_step;
  state.counters["residual"] = candidate.verifying_run().residual.value_or(0);
  progress.add_done(1.0 / repetitions);
}

/// Returns the number of repetitions of a candidate, 3 to 20, that take about 2 s together. Some of
/// them are then likely to be undisturbed, although a core may be slow for seconds.
int worth_repeating(const Candidate& candidate) {
  constexpr double seconds = 2;
  const double needed =
      std::ceil(seconds / std::max(candidate.verifying_run().analysis_seconds, 1e-9));
  return static_cast<int>(std::clamp<double>(needed, 3, 20));
}

/// Returns what a record says of candidates, as an object of arrays.
Json lists_of(const std::vector<Candidate*>& candidates) {
  Json lists;
  for (const char* list : {"candidates", "profiles", "requests"}) lists[list] = Json::array();
  for (const Candidate* candidate : candidates) candidate->add_to(lists);
  return lists;
}

}  // namespace

Json measure(const std::vector<Candidate*>& all, const Console& console, Progress& progress) {
  const auto complain = [&](const Candidate& candidate) {
    progress.clear();
    std::cerr << candidate.name() << ": " << candidate.message() << '\n';
  };
  std::vector<const Candidate*> verified;
  for (Candidate* candidate : all) {
    const auto verify = [&] { candidate->verify(); };
    // Threads that a candidate makes end with the thread that it is on. So those of its
    // verification are gone, and take no room, when its repetitions are timed.
    candidate->threads() > 1 ? run_on_fresh_heap(verify) : verify();
    candidate->profile();
    progress.add_done(candidate->is_verified() ? 1 : work_of_candidate);
    if (candidate->is_failed() || (candidate->is_not_run() && console.has_table))
      complain(*candidate);
    if (candidate->is_verified()) verified.push_back(candidate);
    if (candidate->is_not_run()) continue;
    const int repetitions = console.repetitions.value_or(worth_repeating(*candidate));
    auto* const registered =
        benchmark::RegisterBenchmark(candidate->name().c_str(), &run_timed, std::ref(*candidate),
                                     repetitions, std::ref(progress));
    registered->Unit(benchmark::kMillisecond)->UseManualTime();
    if (!console.repetitions) registered->Repetitions(repetitions);
  }
  CollectingReporter reporter(all, console, progress);
  if (!std::ranges::all_of(all, &Candidate::is_not_run))
    benchmark::RunSpecifiedBenchmarks(&reporter, ".");  // those chosen, whatever the filter
  for (const Candidate* candidate : verified)
    if (candidate->is_failed()) complain(*candidate);
  return {{"failed", std::ranges::any_of(all, &Candidate::is_failed)}, {"lists", lists_of(all)}};
}

}  // namespace desmo::paper
