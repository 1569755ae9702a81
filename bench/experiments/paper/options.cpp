#include "bench/experiments/paper/options.h"

#include <list>

#include "cases/generators/cases.h"

namespace desmo::paper {

namespace {

constexpr double quick_duration = 1.5;  // s
constexpr int quick_repetitions = 2;

void add_options(OptionTable& table, Options& o) {
  bench::add_common(table, o,
                    {.quick = "1.5 s of motion and 2 repetitions",
                     .filtered = "<case>/<coordinates>/<id>",
                     .repetitions = "as many as take 2 s together, 3 to 20"});
  table.add("--step", "SECONDS", &o.step, "Time step (the case's, 0.01)");
  table.add("--duration", "SECONDS", &o.duration, "Motion analysed (the case's, 30)");
  table.add("--dense-limit", "N", &o.dense_limit,
            "Coordinates up to which dense global solves run (114)");
  table.add("--slow-limit", "N", &o.slow_limit,
            "Coordinates up to which SPQR, and UMFPACK and SparseLU\nin blocks, run (114)");
  table.add("--peer-limit", "SECONDS", &o.peer_limit,
            "CPU time a peer may take for the motion (60)");
  table.add("--formulation", "ID", &o.formulations,
            "Add a formulation with settings as suffixes, such as\n"
            "global_automatic_klu/guess:hermite5; more than once where wanted");
}

/// A flag for Google Benchmark, which keeps no copy of its own.
char* lasting(std::string flag) {
  static std::list<std::string> flags;
  return flags.emplace_back(std::move(flag)).data();
}

}  // namespace

std::string usage() {
  Options unused;
  OptionTable table(
      "desmo_bench paper: verifies, then times, every case, size and formulation.\n"
      "A benchmark is named <case>/<coordinates>/<id>; one iteration is the whole analysis.\n"
      "<case>/<coordinates>/<id>/request:<name> solves only what that request needs.\n"
      "<case>/<coordinates>/peer:<name> is solved by a peer: by hand, or, where built\n"
      "(DESMO_PEERS), by a library.");
  add_options(table, unused);
  return table.help() +
         "\nExit code: 0 all verified and timed; 1 some formulation failed; 64 usage, or no\n"
         "benchmark matches; 74 the record could not be written. Flags of Google Benchmark:\n\n";
}

Options take_options(std::vector<char*>& arguments) {
  Options o;
  OptionTable table("");
  add_options(table, o);
  arguments = table.take(arguments);
  o.help = table.asks_for_help();
  if (o.quick && o.duration == 0) o.duration = quick_duration;
  const int repetitions = o.repetitions > 0 ? o.repetitions : o.quick ? quick_repetitions : 0;
  // First, so that flags of Google Benchmark that the user gives win.
  if (repetitions > 0)
    arguments.insert(arguments.begin(),
                     lasting("--benchmark_repetitions=" + std::to_string(repetitions)));
  if (!o.filter.empty())
    arguments.insert(arguments.begin(), lasting("--benchmark_filter=" + o.filter));
  return o;
}

TimeGrid chosen_grid(const TimeGrid& own, const Options& o) {
  const double duration = own.time(own.instants - 1) - own.start;
  return time_grid(o.duration > 0 ? o.duration : duration, o.step > 0 ? o.step : own.step);
}

}  // namespace desmo::paper
