#pragma once

#include <string>
#include <vector>

#include "bench/experiments/options.h"
#include "cases/mechanism/motion.h"

namespace desmo::paper {

using namespace bench;  // the kit, of which this experiment uses nearly all

/// Options of the paper's experiment, without the flags of Google Benchmark.
struct Options : bench::CommonOptions {
  double step = 0;                        ///< s; 0: the case's own
  double duration = 0;                    ///< s; 0: the case's own
  int dense_limit = 114;                  ///< coordinates up to which dense global solves run
  int slow_limit = 114;                   ///< most coordinates for slow libraries (slow_reason)
  double peer_limit = 60;                 ///< s of CPU time a peer may take for the motion
  std::vector<std::string> formulations;  ///< ids with settings, to be run as well as the table's
  std::vector<std::string> scenes;        ///< files to be measured in place of the cases
  bool table = false;                     ///< show every benchmark, though there is a record
  bool help = false;
};

/// Takes our options out of the arguments. Leaves the flags of Google Benchmark, and adds those
/// that our options stand for. Prints the help that is asked for. Throws std::invalid_argument,
/// naming the option, for a missing or unusable value.
Options take_options(std::vector<std::string>& arguments);

/// Returns the instants that are analysed: a scene's own, but for what the options say. A quick run
/// takes the beginning of the motion.
TimeGrid chosen_grid(const TimeGrid& own, const Options& options);

}  // namespace desmo::paper
