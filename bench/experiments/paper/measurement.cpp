#include "bench/experiments/paper/measurement.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/kit/memory/fresh_heap.h"
#include "bench/kit/record/record.h"

namespace desmo::paper {

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
  /// first: the machine has not been described yet.
  CollectingReporter(const std::vector<Candidate*>& all, bool first, RunProgress& progress)
      : ConsoleReporter(OO_Tabular), first_(first), progress_(progress) {
    for (Candidate* timed : all) timed_[timed->name()] = timed;
  }

  bool ReportContext(const Context& context) override {
    if (first_) return ConsoleReporter::ReportContext(context);
    name_field_width_ = context.name_field_width;
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      const auto it = timed_.find(run.run_name.function_name);
      if (it != timed_.end() && run.run_type == Run::RT_Iteration && !run.error_occurred)
        it->second->seconds.push_back(run.real_accumulated_time /
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
  const bool first_;
  RunProgress& progress_;
  std::map<std::string, Candidate*> timed_;
};

/// One repetition.
void run_timed(benchmark::State& state, Candidate& timed, RunProgress& progress) {
  if (timed.state != Candidate::State::verified) return state.SkipWithError(timed.message.c_str());
  for (auto _ : state) {
    state.SetIterationTime(timed.time_afresh());
    if (timed.is_failed()) return state.SkipWithError(timed.message.c_str());
  }
  for (const auto& [name, value] : timed.counters()) state.counters[name] = value;
  progress.repeated(timed);
}

/// As many as take long enough, together, that something of them is undisturbed: a core may be slow
/// for seconds. What takes long itself needs few.
int worth_repeating(const Candidate& timed) {
  constexpr double seconds = 2;
  constexpr int fewest = 3, most = 20;
  const double needed = std::ceil(seconds / std::max(timed.analysis_seconds, 1e-9));
  return static_cast<int>(std::clamp<double>(needed, fewest, most));
}

}  // namespace

nlohmann::ordered_json measure(const std::vector<Candidate*>& all,
                               std::optional<int> asked_repetitions, bool first,
                               RunProgress& progress) {
  progress.begin(all);
  ReferenceCache references;
  for (Candidate* timed : all) {
    const auto verify = [&] { timed->verify(references); };
    // The threads that it makes end with the one that it is on: those of a repetition have no
    // others beside them, for which they would have to make room.
    timed->threads > 1 ? on_fresh_heap(verify) : verify();
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
  CollectingReporter reporter(all, first, progress);
  if (!std::ranges::all_of(all, &Candidate::is_not_run))
    benchmark::RunSpecifiedBenchmarks(&reporter, ".");  // those chosen, whatever the filter
  progress.end();
  return {{"failed", std::ranges::any_of(all, &Candidate::is_failed)}, {"lists", lists_of(all)}};
}

}  // namespace desmo::paper
