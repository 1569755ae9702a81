// desmo_bench size: how the time of a step grows with the size of a mechanism, and where solving
// all of it at once costs the same with dense and with sparse matrices.
#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/size/analysis.h"
#include "bench/experiments/size/record.h"
#include "bench/kit/common_options.h"
#include "bench/kit/memory/kept_memory.h"
#include "bench/kit/process/progress.h"
#include "bench/kit/record/recording.h"
#include "formulations/algebra/blas.h"

namespace desmo::size {

namespace {

constexpr int usual_repetitions = 5;
constexpr double min_seconds = 0.02;  // of a sample
constexpr double dear_seconds = 1;    // a motion that takes longer has two samples only

bool is_sampled(const Contender& contender, const Problem& problem) {
  const std::vector<double>& samples = contender.seconds_per_step;
  return samples.size() >= 2 && samples.front() * problem.grid.instants > dear_seconds;
}

/// How far all series have come. What is left takes as long as what is done did, by size.
class Work {
 public:
  explicit Work(const std::vector<Series>& all) : progress_("sizes", static_cast<int>(all.size())) {
    for (const Series& series : all) left_ += cost(series);
  }
  void done(const Series& series) {
    left_ -= cost(series);
    done_ += cost(series);
    progress_.one_done(progress_.elapsed() * left_ / done_);
  }

 private:
  static double cost(const Series& series) {
    return series.size * static_cast<double>(series.ids.size());
  }
  bench::Progress progress_;
  double left_ = 0, done_ = 0;
};

/// Verifies every formulation, then times them in turn, so that whatever slows the machine down for
/// a while meets them all.
void measure(const Series& series, int repetitions, nlohmann::ordered_json& list) {
  const Problem problem = series.problem();
  std::vector<Contender> contenders;
  for (const std::string_view id : series.ids) contenders.emplace_back(problem, id).verify();
  for (int round = 0; round < repetitions; ++round)
    for (Contender& contender : contenders)
      if (!is_sampled(contender, problem)) contender.time(min_seconds);
  for (const Contender& contender : contenders)
    list.push_back(entry_json(series, problem, contender));
}

/// Whether all that was measured is right; what is not is named.
bool all_right(const nlohmann::ordered_json& lists) {
  bool right = true;
  for (const auto& [name, list] : lists.items())
    for (const auto& entry : list) {
      if (entry["status"] == "ok") continue;
      right = false;
      std::cerr << name << '/' << entry["case"].get<std::string>() << '/' << entry["coordinates"]
                << '/' << entry["id"].get<std::string>() << ": "
                << entry["message"].get<std::string>() << '\n';
    }
  return right;
}

/// Returns whether all that was measured is right.
bool measure_all(const bench::CommonOptions& options, const std::string& command) {
  const std::vector<Series> all =
      matching(options.quick ? quick_series() : all_series(), std::regex(options.filter));
  if (all.empty()) throw std::invalid_argument("nothing matches " + options.filter);
  bench::Recording recording(options.record, command);
  nlohmann::ordered_json lists;
  {
    const int repetitions = options.repetitions > 0 ? options.repetitions : usual_repetitions;
    Work work(all);
    for (const Series& series : all) {
      measure(series, repetitions, lists[std::string(name_of(series.question))]);
      work.done(series);
    }
  }
  recording.write(all.front().definition->describe(1).grid, lists);
  return all_right(lists);
}

/// Whether all files could be solved; one that could not is named.
bool analyse(const std::vector<int>& bodies) {
  try {
    print_analysis(bodies);
    return true;
  } catch (const std::runtime_error& error) {
    std::cerr << "desmo_bench: " << error.what() << '\n';
    return false;
  }
}

/// Turns words into numbers of bodies. Throws std::invalid_argument, naming one that is none.
std::vector<int> bodies_of(const std::vector<std::string>& words) {
  if (words.empty()) return {100, 1000, 10'000};
  std::vector<int> all;
  for (const std::string& word : words) {
    int bodies = 0;
    const char* const end = word.data() + word.size();
    if (std::from_chars(word.data(), end, bodies).ptr != end || bodies < 20 || bodies > 1'000'000)
      throw std::invalid_argument("'" + word + "' is not a number of bodies from 20 to 1000000");
    all.push_back(bodies);
  }
  return all;
}

int run(const bench::CommandLine& line) {
  bench::CommonOptions options;
  bool analyses_files = false;
  bench::OptionTable table(
      "desmo_bench size: how time grows with the size of a mechanism.\n"
      "desmo_bench size --files [BODIES...]");
  bench::add_common(table, options,
                    {.quick = "small sizes only",
                     .filtered = "<question>/<case>/<size>/<id>, such as\n"
                                 "growth/four_bar/114/group_symbolic_inlined",
                     .repetitions = std::to_string(usual_repetitions)});
  table.flag("--files", analyses_files,
             "Instead: how reading, analysing and solving a mechanism file\n"
             "grow with its bodies (100 1000 10000), as a table");
  std::vector<std::string> words;
  if (!bench::read_options(table, line, &words)) return 0;
  if (!analyses_files && !words.empty())
    throw std::invalid_argument("unknown argument '" + words.front() + "'");
  if (analyses_files && !options.record.empty())
    throw std::invalid_argument("--files prints a table; it goes into no --record");
  bench::keep_freed_memory();
  set_blas_threads(1);  // the clock is the thread's own
  const bool right = analyses_files ? analyse(bodies_of(words)) : measure_all(options, line.text);
  return right ? 0 : 1;
}

}  // namespace

}  // namespace desmo::size

int desmo::bench::run_size(const CommandLine& line) { return desmo::size::run(line); }
