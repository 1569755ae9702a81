// The subcommands: one file each, and one name in this list.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

namespace desmo::cli {

/// Adds a subcommand, whose callback does the work and throws what errors.h lists.
using AddCommand = void(CLI::App& program);

/// For options: an empty text is more likely a variable that is not set.
inline std::string refuse_empty(const std::string& text) {
  return text.empty() ? "is empty; give a value or leave the option out" : "";
}

/// For options that are numbers: CLI11's bounds let this pass.
inline std::string refuse_nan(const std::string& text) {
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? "is not a number" : "";
}

AddCommand add_list, add_show, add_inspect, add_solve, add_tune;
inline constexpr AddCommand* commands[] = {add_list, add_show, add_inspect, add_solve, add_tune};

}  // namespace desmo::cli
