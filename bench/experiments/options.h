#pragma once

#include <string>
#include <vector>

#include "bench/kit/record/record.h"

namespace CLI {
class App;
}

namespace desmo::bench {

/// The arguments of an experiment.
struct CommandLine {
  std::string experiment;
  std::string text;                    ///< program, experiment and arguments, for the record
  std::string program;                 ///< path of the program, as Google Benchmark takes it
  std::vector<std::string> arguments;  ///< without program and experiment
};

/// Options that mean the same in every experiment that has them.
struct CommonOptions {
  std::string record;   ///< file for the results record; empty: none
  bool quick = false;   ///< measure only what CommonHelp::quick says
  int repetitions = 0;  ///< samples of each time; 0: as many as the experiment takes by itself
  std::string filter;   ///< regular expression; empty: everything

  /// Returns the number of samples of each time: `usual` ones unless the user chooses.
  int samples(int usual, int in_quick_run) const {
    return repetitions > 0 ? repetitions : quick ? in_quick_run : usual;
  }
};

/// Meanings of the common options in one experiment, for its help.
struct CommonHelp {
  std::string quick;        ///< description of what is measured with --quick
  std::string filtered;     ///< names that --filter searches: "<case>/<coordinates>/<id>"
  std::string repetitions;  ///< how many samples it takes by itself; empty: it has no such option
};

/// Adds the options to those of an experiment; `options` must outlive them.
void add_common(CLI::App& parser, CommonOptions& options, const CommonHelp& help);

/// Returns the message that rejects a text which does not begin with a positive, finite number; ""
/// accepts the text. For CLI::Option::check.
std::string refuse_not_positive(const std::string& text);

/// Reads all arguments. Returns false after printing the help that was asked for. Throws
/// std::invalid_argument for an argument that is unusable or, unless the parser allows extras,
/// unknown.
bool read(CLI::App& parser, const std::vector<std::string>& arguments);

/// Returns the path of another program of bench/, in the folder of this one.
std::string beside_this_program(const std::string& name);

/// Begins the record of an experiment. Throws what RecordWriter throws.
inline RecordWriter begin_record(const CommonOptions& options, const CommandLine& line) {
  return {options.record, line.text, line.experiment};
}

}  // namespace desmo::bench
