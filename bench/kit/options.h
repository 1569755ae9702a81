#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace desmo::bench {

/// The arguments of an experiment.
struct CommandLine {
  std::string text;              ///< for the record: program, experiment and arguments
  char* program;                 ///< its path, as Google Benchmark wants it
  std::vector<char*> arguments;  ///< without program and experiment
};

/// The options of a command line, each with its help. A value follows its option, or stands after
/// it and "=".
///
///     OptionTable table("desmo_bench size: how time grows");
///     table.add("--repetitions", "N", &repetitions, "Samples of each time");
///     const std::vector<char*> rest = table.take(arguments);
class OptionTable {
 public:
  /// The place of a value, which must outlive the table. Numbers must be positive; an option with a
  /// vector may be given more than once.
  using Target = std::variant<bool*, std::string*, int*, double*, std::vector<std::string>*,
                              std::vector<int>*>;

  /// title: the first lines of help().
  explicit OptionTable(std::string title);
  OptionTable(const OptionTable&) = delete;  // an option refers to the table
  OptionTable& operator=(const OptionTable&) = delete;

  /// Adds an option. value: its name in the help; empty for a flag, whose target is a bool.
  void add(std::string name, std::string value, Target target, std::string help);

  /// Sets the targets and returns the arguments that are no option of the table. Throws
  /// std::invalid_argument, naming the option, for a missing or unusable value.
  std::vector<char*> take(const std::vector<char*>& arguments) const;

  /// Reads the whole command line of an experiment; words: receives what does not begin with "-",
  /// where the experiment has a use for it. Returns false after printing the help that was asked
  /// for. Throws std::invalid_argument, naming the argument, for one that the table has not.
  bool read(const CommandLine& line, std::vector<std::string>* words = nullptr) const;

  /// Tells whether --help or -h was among the arguments taken.
  bool asks_for_help() const { return asks_for_help_; }
  /// Returns the title, and what each option does.
  std::string help() const;

 private:
  struct Option {
    std::string name, value;
    Target target;
    std::string help;
  };

  std::string title_;
  std::vector<Option> options_;
  bool asks_for_help_ = false;
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

/// Adds the options to a table; `options` must outlive it.
void add_common(OptionTable& table, CommonOptions& options, const CommonHelp& help);

/// Returns the whole number that a text is. Throws std::invalid_argument, naming the text, when it
/// is none from min to max.
int whole_number(std::string_view text, int min, int max);

}  // namespace desmo::bench
