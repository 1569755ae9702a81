#include "bench/kit/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace desmo::bench {

namespace {

constexpr std::size_t help_column = 26;

template <class Number>
Number positive_number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > 0) ||
      !std::isfinite(static_cast<double>(value)))
    throw std::invalid_argument("'" + std::string(text) + "' is not a positive " +
                                (std::is_integral_v<Number> ? "whole number" : "number"));
  return value;
}

void set(std::string& target, std::string_view text) { target = text; }
void set(int& target, std::string_view text) { target = positive_number<int>(text); }
void set(double& target, std::string_view text) { target = positive_number<double>(text); }
void set(bool& target, std::string_view) { target = true; }
template <class Element>
void set(std::vector<Element>& target, std::string_view text) {
  set(target.emplace_back(), text);
}

}  // namespace

OptionTable::OptionTable(std::string title) : title_(std::move(title)) {
  add("--help", {}, &asks_for_help_, "Show this");
}

void OptionTable::add(std::string name, std::string value, Target target, std::string help) {
  options_.push_back({std::move(name), std::move(value), target, std::move(help)});
}

std::vector<char*> OptionTable::take(const std::vector<char*>& arguments) const {
  std::vector<char*> rest;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    const std::string_view name = argument.substr(0, argument.find('='));
    const auto option = std::ranges::find(options_, name == "-h" ? "--help" : name, &Option::name);
    if (option == options_.end()) {
      rest.push_back(arguments[i]);
      continue;
    }
    const auto refuse = [&](const std::string& why) {
      throw std::invalid_argument(std::string(name) + ": " + why);
    };
    std::string_view value = argument.substr(std::min(argument.size(), name.size() + 1));
    const bool has_value = name.size() < argument.size();
    if (option->value.empty() && has_value) refuse("takes no value");
    if (!option->value.empty() && !has_value) {
      if (i + 1 == arguments.size()) refuse("a value is missing");
      value = arguments[++i];
    }
    try {
      std::visit([&](auto* target) { set(*target, value); }, option->target);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
  }
  return rest;
}

bool OptionTable::read(const CommandLine& line, std::vector<std::string>* words) const {
  for (const char* argument : take(line.arguments)) {
    if (asks_for_help_) break;
    if (!words || *argument == '-')
      throw std::invalid_argument("unknown argument '" + std::string(argument) + "'");
    words->emplace_back(argument);
  }
  if (asks_for_help_) std::cout << help();
  return !asks_for_help_;
}

std::string OptionTable::help() const {
  std::string text = title_ + "\n\n";
  for (const Option& option : options_) {
    std::string line = "  " + option.name + (option.value.empty() ? "" : " " + option.value);
    if (line.size() + 2 > help_column)
      line += '\n' + std::string(help_column, ' ');
    else
      line.resize(help_column, ' ');
    for (const char c : option.help)
      line += c == '\n' ? '\n' + std::string(help_column, ' ') : std::string(1, c);
    text += line + '\n';
  }
  return text;
}

void add_common(OptionTable& table, CommonOptions& options, const CommonHelp& help) {
  table.add("--record", "FILE", &options.record, "Write the results record to this file");
  table.add("--quick", {}, &options.quick, "A first look: " + help.quick);
  if (!help.repetitions.empty())
    table.add("--repetitions", "N", &options.repetitions,
              "Samples of each time (" + help.repetitions + ")");
  table.add("--filter", "REGEX", &options.filter,
            "Only where this regular expression is found in\n" + help.filtered);
}

int whole_number(std::string_view text, int min, int max) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || value < min || value > max)
    throw std::invalid_argument("'" + std::string(text) + "' is not a whole number from " +
                                std::to_string(min) + " to " + std::to_string(max));
  return value;
}

}  // namespace desmo::bench
