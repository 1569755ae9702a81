#pragma once

#include <string>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/kit/option_table.h"

namespace desmo::bench {

/// Options that mean the same in every experiment that has them.
struct CommonOptions {
  std::string record;   ///< file for the results record; empty: none
  bool quick = false;   ///< a first look
  int repetitions = 0;  ///< samples of each time; 0: as many as the experiment takes by itself
  std::string filter;   ///< regular expression; empty: everything
};

/// The help text that an experiment gives them.
struct CommonHelp {
  std::string quick;        ///< what is left out
  std::string filtered;     ///< what the filter is searched in: "<case>/<coordinates>/<id>"
  std::string repetitions;  ///< how many there are without the option; empty: no such option
};

/// Adds the options to a table; `options` must outlive it.
void add_common(bench::OptionTable& table, CommonOptions& options, const CommonHelp& help);

/// Reads the whole command line of an experiment; words: receives what does not begin with "-",
/// where the experiment has a use for it. Returns false after printing the help that was asked for.
/// Throws std::invalid_argument, naming the argument, for one that the table has not.
bool read_options(const bench::OptionTable& table, const CommandLine& line,
                  std::vector<std::string>* words = nullptr);

}  // namespace desmo::bench
