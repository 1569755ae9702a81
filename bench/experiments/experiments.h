#pragma once

#include <string_view>

#include "bench/kit/options.h"

namespace desmo::bench {

/// An experiment: `desmo_bench NAME [OPTION...]`.
struct Experiment {
  std::string_view name;
  std::string_view help;  ///< one line
  /// Measures, and returns the exit code: 0, or 1 where something that was measured is wrong.
  /// Throws std::invalid_argument and std::regex_error for a mistake in the command line, any
  /// other exception where something cannot be measured or written.
  int (*run)(const CommandLine&);
};

// Each stands in its folder, and in the table of main.cpp.
int run_paper(const CommandLine&);
int run_accuracy(const CommandLine&);
int run_size(const CommandLine&);
int run_instructions(const CommandLine&);
int run_extremes(const CommandLine&);
int run_promise(const CommandLine&);

}  // namespace desmo::bench
