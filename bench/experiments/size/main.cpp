// desmo_growth: how the time of a step grows with the size of a mechanism, and where solving all of
// it at once costs the same with dense and with sparse matrices, into a record; without one, how
// reading, analysing and solving a mechanism file grow, as a table.
#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/size/analysis.h"
#include "bench/experiments/size/record.h"
#include "bench/kit/kept_memory.h"
#include "bench/kit/progress.h"
#include "bench/kit/recording.h"
#include "formulations/algebra/blas.h"

namespace desmo::sizes {

namespace {

constexpr double least_seconds = 0.02;  // of a sample
constexpr double dear_seconds = 1;      // a motion that takes longer has two samples only

struct Options {
  std::string record, command, filter;
  int repetitions = 5;
  bool quick = false;
  std::vector<int> bodies{100, 1000, 10'000};
};

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
  suite::Progress progress_;
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
      if (!is_sampled(contender, problem)) contender.time(least_seconds);
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

bool run(const Options& options) {
  suite::keep_freed_memory();
  set_blas_threads(1);  // the clock is the thread's own
  const std::vector<Series> all =
      matching(options.quick ? quick_series() : all_series(), std::regex(options.filter));
  if (all.empty()) throw std::invalid_argument("nothing matches " + options.filter);
  suite::Recording recording(options.record, options.command);
  nlohmann::ordered_json lists;
  {
    Work work(all);
    for (const Series& series : all) {
      measure(series, options.repetitions, lists[std::string(name_of(series.question))]);
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
    std::cerr << "desmo_growth: " << error.what() << '\n';
    return false;
  }
}

}  // namespace

}  // namespace desmo::sizes

int main(int argc, char** argv) {
  using namespace desmo::sizes;
  CLI::App program{"How time grows with the size of a mechanism", "desmo_growth"};
  Options options;
  const auto* record =
      program.add_option("--record", options.record, "Write the results record to this file");
  program.add_option("--repetitions", options.repetitions, "Samples of each time")
      ->check(CLI::PositiveNumber);
  program.add_flag("--quick", options.quick, "Small sizes only");
  program.add_option("--filter", options.filter,
                     "Only where this regular expression is found in "
                     "<growth|break_even>/<case>/<size>/<id>");
  program
      .add_option("bodies", options.bodies,
                  "Without --record: numbers of bodies of the files that are read and analysed")
      ->check(CLI::Range(20, 1'000'000))
      ->excludes("--record");
  options.command = desmo::suite::command_line(argc, argv);
  return desmo::suite::record_main(program, argc, argv, [&] {
    return record->empty() ? analyse(options.bodies) : run(options);
  });
}
