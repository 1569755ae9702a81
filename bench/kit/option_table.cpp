#include "bench/kit/option_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
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

}  // namespace

OptionTable::OptionTable(std::string title) : title_(std::move(title)) {
  flag("--help", asks_for_help_, "Show this");
}

void OptionTable::flag(std::string name, bool& target, std::string help) {
  options_.push_back({std::move(name), {}, std::move(help), [&target](auto) { target = true; }});
}

void OptionTable::text(std::string name, std::string value, std::string& target, std::string help) {
  options_.push_back({std::move(name), std::move(value), std::move(help),
                      [&target](auto given) { target = given; }});
}

void OptionTable::texts(std::string name, std::string value, std::vector<std::string>& target,
                        std::string help) {
  options_.push_back({std::move(name), std::move(value), std::move(help),
                      [&target](auto given) { target.emplace_back(given); }});
}

void OptionTable::positive(std::string name, std::string value, int& target, std::string help) {
  options_.push_back({std::move(name), std::move(value), std::move(help),
                      [&target](auto given) { target = positive_number<int>(given); }});
}

void OptionTable::positive(std::string name, std::string value, double& target, std::string help) {
  options_.push_back({std::move(name), std::move(value), std::move(help),
                      [&target](auto given) { target = positive_number<double>(given); }});
}

void OptionTable::positives(std::string name, std::string value, std::vector<int>& target,
                            std::string help) {
  options_.push_back({std::move(name), std::move(value), std::move(help),
                      [&target](auto given) { target.push_back(positive_number<int>(given)); }});
}

const OptionTable::Option* OptionTable::find(std::string_view name) const {
  const auto it = std::ranges::find(options_, name == "-h" ? "--help" : name, &Option::name);
  return it == options_.end() ? nullptr : &*it;
}

std::vector<char*> OptionTable::take(const std::vector<char*>& arguments) const {
  std::vector<char*> rest;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    const std::string_view name = argument.substr(0, argument.find('='));
    const bool has_value = name.size() < argument.size();
    const Option* option = find(name);
    if (!option) {
      rest.push_back(arguments[i]);
      continue;
    }
    try {
      if (option->value.empty() && has_value) throw std::invalid_argument("takes no value");
      if (option->value.empty())
        option->set({});
      else if (has_value)
        option->set(argument.substr(name.size() + 1));
      else if (i + 1 < arguments.size())
        option->set(arguments[++i]);
      else
        throw std::invalid_argument("a value is missing");
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string(name) + ": " + error.what());
    }
  }
  return rest;
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

void require_none(const std::vector<char*>& arguments) {
  if (!arguments.empty())
    throw std::invalid_argument("unknown argument '" + std::string(arguments.front()) + "'");
}

}  // namespace desmo::bench
