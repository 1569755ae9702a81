#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::bench {

/// The options of a command line, each with its help. A value follows its option, or stands after
/// it and "=".
///
///     OptionTable table("desmo_bench size: how time grows");
///     table.positive("--repetitions", "N", repetitions, "Samples of each time");
///     const std::vector<char*> rest = table.take(arguments);
class OptionTable {
 public:
  /// title: the first lines of help().
  explicit OptionTable(std::string title);
  OptionTable(const OptionTable&) = delete;  // an option refers to the table
  OptionTable& operator=(const OptionTable&) = delete;

  // Every target must outlive the table.
  void flag(std::string name, bool& target, std::string help);
  void text(std::string name, std::string value, std::string& target, std::string help);
  /// An option that may be given more than once.
  void texts(std::string name, std::string value, std::vector<std::string>& target,
             std::string help);
  void positive(std::string name, std::string value, int& target, std::string help);
  void positive(std::string name, std::string value, double& target, std::string help);
  /// An option that may be given more than once.
  void positives(std::string name, std::string value, std::vector<int>& target, std::string help);

  /// Sets the targets and returns the arguments that are no option of the table. Throws
  /// std::invalid_argument, naming the option, for a missing or unusable value.
  std::vector<char*> take(const std::vector<char*>& arguments) const;

  /// Tells whether --help or -h was among the arguments taken.
  bool asks_for_help() const { return asks_for_help_; }
  /// The title, and what each option does.
  std::string help() const;

 private:
  using Set = std::function<void(std::string_view)>;
  struct Option {
    std::string name, value;  // no value: a flag
    std::string help;
    Set set;  // throws std::invalid_argument without naming the option
  };
  const Option* find(std::string_view name) const;

  std::string title_;
  std::vector<Option> options_;
  bool asks_for_help_ = false;
};

/// Refuses arguments that nothing has taken. Throws std::invalid_argument, naming the first.
void require_none(const std::vector<char*>& arguments);

}  // namespace desmo::bench
