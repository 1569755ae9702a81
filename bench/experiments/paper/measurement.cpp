#include "bench/experiments/paper/measurement.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "bench/experiments/paper/options.h"
#include "bench/kit/memory.h"

namespace desmo::paper {

namespace {

using Json = nlohmann::ordered_json;

/// Returns a run as the console is to show it: the time given to Google Benchmark by hand is CPU
/// time, and what it finds itself is that of a thread that waits.
benchmark::BenchmarkReporter::Run shown_as_cpu_time(benchmark::BenchmarkReporter::Run run) {
  run.run_name.time_type.clear();
  run.run_name.repetitions.clear();
  run.cpu_accumulated_time = run.real_accumulated_time;
  return run;
}

/// A reporter that keeps the raw samples of all candidates and shows a summary on the console.
class CollectingReporter final : public benchmark::ConsoleReporter {
 public:
  /// first: the machine has not been described yet.
  CollectingReporter(const std::vector<Candidate*>& all, bool first, Progress& progress)
      : ConsoleReporter(OO_Tabular), first_(first), progress_(progress) {
    for (Candidate* candidate : all) candidates_[candidate->name()] = candidate;
  }

  bool ReportContext(const Context& context) override {
    if (first_) return ConsoleReporter::ReportContext(context);
    name_field_width_ = context.name_field_width;
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      const auto it = candidates_.find(run.run_name.function_name);
      if (it != candidates_.end() && run.run_type == Run::RT_Iteration && !run.error_occurred)
        it->second->measure([&](VerifiedCandidate& verified) {
          verified.add_sample(run.real_accumulated_time / static_cast<double>(run.iterations));
        });
      if (run.error_occurred || run.repetitions == 1 || run.aggregate_name == "median" ||
          run.aggregate_name == "cv")
        shown.push_back(shown_as_cpu_time(run));
      if (run.error_occurred) break;  // the other repetitions say the same
    }
    progress_.clear();
    ConsoleReporter::ReportRuns(shown);
  }

 private:
  const bool first_;
  Progress& progress_;
  std::map<std::string, Candidate*> candidates_;
};

/// Takes one of so many repetitions.
void run_timed(benchmark::State& state, Candidate& candidate, int repetitions, Progress& progress) {
  if (!candidate.is_verified()) return state.SkipWithError(candidate.message().c_str());
  for (auto _ : state) {
    candidate.measure(
        [&](VerifiedCandidate& verified) { state.SetIterationTime(verified.time_afresh()); });
    if (candidate.is_failed()) return state.SkipWithError(candidate.message().c_str());
  }
  state.counters["iterations/step"] = candidate.verifying_run().iterations_per_step;
  state.counters["residual"] = candidate.verifying_run().residual;
  progress.done(1.0 / repetitions);
}

/// Returns as many as take long enough, together, that something of them is undisturbed: a core may
/// be slow for seconds. What takes long itself needs less.
int worth_repeating(const Candidate& candidate) {
  constexpr double seconds = 2;
  const double needed =
      std::ceil(seconds / std::max(candidate.verifying_run().analysis_seconds, 1e-9));
  return static_cast<int>(std::clamp<double>(needed, 3, 20));
}

}  // namespace

Json lists_of(const std::vector<Candidate*>& candidates) {
  Json lists;
  for (const char* list : {"cells", "profiles", "requests"}) lists[list] = Json::array();
  for (const Candidate* candidate : candidates) candidate->add_to(lists);
  return lists;
}

Json measure(const std::vector<Candidate*>& all, std::optional<int> asked_repetitions, bool first,
             Progress& progress) {
  ReferenceCache references;
  for (Candidate* candidate : all) {
    const auto verify = [&] { candidate->verify(references); };
    // The threads that it makes end with the one that it is on: those of a repetition have no
    // others next to them, for which they would have to make room.
    candidate->threads() > 1 ? on_fresh_heap(verify) : verify();
    candidate->profile();
    progress.done(candidate->is_verified() ? 1 : work_of_candidate);
    if (!candidate->is_verified()) {
      progress.clear();
      std::cerr << candidate->name() << ": " << candidate->message() << '\n';
    }
    if (candidate->is_not_run()) continue;
    const int repetitions = asked_repetitions.value_or(worth_repeating(*candidate));
    auto* const registered =
        benchmark::RegisterBenchmark(candidate->name().c_str(), &run_timed, std::ref(*candidate),
                                     repetitions, std::ref(progress));
    registered->Unit(benchmark::kMillisecond)->UseManualTime();
    if (!asked_repetitions) registered->Repetitions(repetitions);
  }
  CollectingReporter reporter(all, first, progress);
  if (!std::ranges::all_of(all, &Candidate::is_not_run))
    benchmark::RunSpecifiedBenchmarks(&reporter, ".");  // those chosen, whatever the filter
  return {{"failed", std::ranges::any_of(all, &Candidate::is_failed)}, {"lists", lists_of(all)}};
}

}  // namespace desmo::paper
