#pragma once

#include <string>
#include <vector>

#include "bench/experiments/options.h"
#include "cases/mechanism/motion.h"

namespace desmo::paper {

/// Options of the paper's experiment, without the flags of Google Benchmark.
struct Options : bench::CommonOptions {
  double step = 0;         ///< time between instants [s]; 0: the case's own
  double duration = 0;     ///< duration of the motion [s]; 0: the case's own
  int dense_limit = 114;   ///< most coordinates (≤) for dense global solves
  int slow_limit = 114;    ///< most coordinates (≤) for slow libraries (slow_reason)
  double peer_limit = 60;  ///< CPU time that a peer may take for the motion [s] (≤)
  std::vector<std::string> formulations;  ///< ids with settings, to be run as well as the table's
  std::vector<std::string> scenes;        ///< files to be measured in place of the cases
  bool table = false;                     ///< show every benchmark, also where a record is written
  bool help = false;
};

/// Takes our options out of the arguments. Leaves the flags of Google Benchmark, and adds those
/// that our options stand for. Prints the help that is asked for. Throws std::invalid_argument,
/// naming the option, for a missing or unusable value.
Options take_options(std::vector<std::string>& arguments);

/// Returns the instants that are analysed: a scene's own, except for step and duration that the
/// options give. A quick run without a duration takes the first 1.5 s of a longer motion.
TimeGrid chosen_grid(const TimeGrid& own, const Options& options);

}  // namespace desmo::paper
