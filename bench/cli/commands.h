// Subcommands of `desmo`: one file each, and one name in this list.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/mechanism/names.h"

namespace desmo::cli {

/// A function that adds a subcommand with its options and examples.
using AddCommand = void(CLI::App& program);

/// A subcommand, and its options, which live as long as it does.
template <class Options>
struct Command {
  CLI::App& app;
  Options& options;
};

/// Adds a subcommand without options; the caller adds them to what is returned. run: does the
/// subcommand's work once its options are read; may throw what report_current_exception() reports.
template <class Options>
Command<Options> add_command(CLI::App& program, const std::string& name,
                             const std::string& description, void (*run)(const Options&)) {
  CLI::App* const app = program.add_subcommand(name, description);
  const auto options = std::make_shared<Options>();
  app->callback([options, run] { run(*options); });
  return {*app, *options};
}

/// Returns the message that rejects an empty option text, most likely from an unset variable; ""
/// accepts the text. For CLI::Option::check.
inline std::string refuse_empty(const std::string& text) {
  return text.empty() ? "is empty; give a value or leave the option out" : "";
}

/// Returns the message that rejects an option's value that is not above 0 and finite; "" accepts
/// it. CLI::PositiveNumber would print the largest double with all its digits. For
/// CLI::Option::check.
inline std::string require_positive(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || std::isnan(value)) return "is not a number";
  return value > 0 && std::isfinite(value) ? "" : "must be positive and finite";
}

/// Adds the required argument of a command that takes a scene.
inline void add_scene(CLI::App& command, std::string& scene) {
  command
      .add_option("scene", scene,
                  "Scene file, - for standard input, library mechanism (its scene), or scalable "
                  "case with its units, such as truck_suspension:5")
      ->required();
}

/// Adds the option that names the output file of a command.
inline void add_output(CLI::App& command, std::string& output) {
  command
      .add_option("-o,--output", output,
                  "Write to this file, whole or not at all, instead of standard output")
      ->check(refuse_empty);
}

/// Adds the option that leaves out progress, and all notes except those on flags.
inline void add_quiet(CLI::App& command, bool& quiet) {
  command.add_flag("--quiet", quiet, "No progress, and no notes but flags");
}

/// The values of an option, each with its name on the command line.
template <class Value>
using Choices = std::vector<std::pair<std::string_view, Value>>;

/// Returns the value that has a name. Throws CLI::ValidationError, with the nearest names, where
/// none has it.
template <class Value>
Value chosen(const std::string& option, std::string_view name, const Choices<Value>& choices) {
  std::vector<std::string_view> known;
  for (const auto& [choice, value] : choices) {
    if (choice == name) return value;
    known.push_back(choice);
  }
  throw CLI::ValidationError(
      option, in_quotes(name) + " is none of its values; " + suggestion(name, known));
}

/// Adds an option whose value has one of these names; `value` must outlive the command.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& option, Value& value,
                        const Choices<Value>& choices, const std::string& description) {
  const std::string names = joined(choices | std::views::keys, std::identity{}, "|");
  const auto choose = [option, &value, choices](const std::string& given) {
    value = chosen(option, given, choices);
  };
  return command.add_option_function<std::string>(option, choose, description)->type_name(names);
}

AddCommand add_list, add_show, add_inspect, add_solve, add_view, add_range, add_tune;
inline constexpr AddCommand* commands[] = {add_list, add_show,  add_inspect, add_solve,
                                           add_view, add_range, add_tune};

}  // namespace desmo::cli
