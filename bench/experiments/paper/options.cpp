#include "bench/experiments/paper/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

namespace desmo::paper {

namespace {

constexpr double quick_duration = 1.5;  // longest motion of a quick run [s] (≤)
constexpr int quick_repetitions = 2;

}  // namespace

Options take_options(std::vector<std::string>& arguments) {
  Options o;
  CLI::App parser(
      "desmo_bench paper: verifies, then times, every case, size and formulation.\n"
      "A benchmark is named <case>/<coordinates>/<id>; one iteration is the whole analysis.\n"
      "<case>/<coordinates>/<id>/check:proof is proven, as by desmo solve; /check:sample at "
      "intervals.\n"
      "<case>/<coordinates>/<id>/request:<name> solves only what that request needs.\n"
      "<case>/<coordinates>/peer:<name> is solved by a peer: by hand, or, where built\n"
      "(DESMO_PEERS), by a library.");
  parser.set_help_flag();  // Google Benchmark has one, too
  parser.allow_extras();
  parser.add_flag("-h,--help", o.help, "Show this");
  bench::add_common(parser, o,
                    {.quick = "1.5 s of motion and 2 repetitions",
                     .filtered = "<case>/<coordinates>/<id>",
                     .repetitions = "as many as take 2 s together, 3 to 20"});
  const auto add_limit = [&](const char* name, auto& value, const char* unit, const char* help) {
    parser.add_option(name, value, help)->type_name(unit)->check(bench::refuse_not_positive);
  };
  add_limit("--step", o.step, "SECONDS", "Time step (the case's, 0.01)");
  add_limit("--duration", o.duration, "SECONDS", "Motion analysed (the case's, 30)");
  add_limit("--dense-limit", o.dense_limit, "N",
            "Coordinates up to which dense global solves run (114)");
  add_limit("--slow-limit", o.slow_limit, "N",
            "Coordinates up to which SPQR, and UMFPACK and SparseLU in blocks, run (114)");
  add_limit("--peer-limit", o.peer_limit, "SECONDS",
            "CPU time a peer may take for the motion (60)");
  parser
      .add_option("--formulation", o.formulations,
                  "Add a formulation with settings as suffixes, such as "
                  "global_automatic_klu/guess:hermite5; more than once where wanted")
      ->type_name("ID")
      ->allow_extra_args(false);
  parser
      .add_option("--scene", o.scenes,
                  "Measure the whole mechanism of this scene file, in place of the cases; more "
                  "than once where wanted")
      ->type_name("FILE")
      ->allow_extra_args(false);
  parser.add_flag("--table", o.table, "Show every benchmark, as without --record");
  bench::read(parser, arguments);
  arguments = parser.remaining();
  if (o.help)
    std::cout
        << parser.help()
        << "\nExit code: 0 all verified and timed; 1 some formulation failed; 64 usage, or no\n"
           "benchmark matches; 65 a scene says something wrong, 66 cannot be read; 74 the record\n"
           "could not be written. Where a file of Google Benchmark names a library built for\n"
           "debugging, its own is meant, which has no part in these times. Flags of Google\n"
           "Benchmark:\n\n";
  const int repetitions = o.samples(0, quick_repetitions);
  // First, so that flags of Google Benchmark that the user gives win.
  if (repetitions > 0)
    arguments.insert(arguments.begin(), "--benchmark_repetitions=" + std::to_string(repetitions));
  if (!o.filter.empty()) arguments.insert(arguments.begin(), "--benchmark_filter=" + o.filter);
  return o;
}

TimeGrid chosen_grid(const TimeGrid& own, const Options& o) {
  double duration = own.time(own.instants - 1) - own.start;
  const bool is_shortened = o.quick && duration > quick_duration;
  if (!is_shortened && o.duration == 0 && o.step == 0) return own;
  if (o.duration > 0)
    duration = o.duration;
  else if (is_shortened)
    duration = quick_duration;
  TimeGrid grid = time_grid(duration, o.step > 0 ? o.step : own.step);
  grid.start = own.start;
  return grid;
}

}  // namespace desmo::paper
