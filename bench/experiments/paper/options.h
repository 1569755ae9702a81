#pragma once

#include <string>
#include <vector>

#include "cases/motion.h"

namespace desmo::suite {

/// What desmo_bench takes beside the flags of Google Benchmark.
struct Options {
  double step = 0;         ///< s; 0: the case's own
  double duration = 0;     ///< s; 0: the case's own
  int dense_limit = 114;   ///< coordinates up to which dense global solves run
  int slow_limit = 114;    ///< likewise of SPQR, and of UMFPACK and SparseLU in blocks
  double peer_limit = 60;  ///< s of CPU time a rival may take for the motion
  std::string record;      ///< file for the results record; empty: none
  std::vector<std::string> formulations;  ///< ids with settings, to be run beside the table's
  bool help = false;
};

/// Takes our options out of argv and leaves the rest. Throws std::invalid_argument, naming the
/// option, for a missing or unusable value.
Options take_options(std::vector<char*>& arguments);

/// The instants that are analysed: a scene's own, but for what the options say.
TimeGrid chosen_grid(const TimeGrid& own, const Options& options);

/// Text of --help.
extern const char* const usage;

}  // namespace desmo::suite
