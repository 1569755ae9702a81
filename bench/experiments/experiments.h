#pragma once

#include <string>
#include <vector>

#include "bench/kit/record/record.h"

namespace CLI {
class App;
}

namespace desmo::bench {

/// The table of experiments, the paper's first: each name with one line of help. NAME is measured
/// by run() of namespace NAME in experiments/NAME/run.cpp.
#define DESMO_EXPERIMENTS(X)                                                           \
  X(paper, "CPU time of every case, size and formulation: the paper's Tables 1 and 2") \
  X(accuracy, "Time against error of formulations and their settings")                 \
  X(size, "How time grows with the size of a mechanism")                               \
  X(instructions, "Instructions a step, counted by callgrind")                         \
  X(extremes, "Every formulation where most go wrong")                                 \
  X(promise, "Random and aimed scenes: is every number right, or flagged?")

/// The arguments of an experiment.
struct CommandLine {
  std::string experiment;
  std::string text;                    ///< for the record: program, experiment and arguments
  std::string program;                 ///< its path, as Google Benchmark wants it
  std::vector<std::string> arguments;  ///< without program and experiment
};

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

/// Adds the options to those of an experiment; `options` must outlive them.
void add_common(CLI::App& parser, CommonOptions& options, const CommonHelp& help);

/// Refuses what is no positive number, for CLI::Option::check. Returns the message.
std::string refuse_not_positive(const std::string& text);

/// Reads all arguments. Returns false after printing the help that was asked for. Throws
/// std::invalid_argument for an argument that is unknown or unusable.
bool read(CLI::App& parser, const std::vector<std::string>& arguments);

/// Begins the record of an experiment. Throws what RecordWriter throws.
inline RecordWriter begin_record(const CommonOptions& options, const CommandLine& line) {
  return {options.record, line.text, line.experiment};
}

}  // namespace desmo::bench

/// Each measures, and returns the exit code: 0, or 1 where something that was measured is wrong.
/// Throws std::invalid_argument and std::regex_error for a mistake in the command line, any other
/// exception where something cannot be measured or written.
#define DESMO_DECLARE(name, help)     \
  namespace desmo::name {             \
  int run(const bench::CommandLine&); \
  }
DESMO_EXPERIMENTS(DESMO_DECLARE)
#undef DESMO_DECLARE
