// Subcommands of `desmo`: one file each, and one name in this list.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

namespace desmo::cli {

/// Adds a subcommand, whose callback does the work and throws the errors of errors.h.
using AddCommand = void(CLI::App& program);

/// Rejects an empty option text, most likely from an unset variable. Returns the message.
inline std::string refuse_empty(const std::string& text) {
  return text.empty() ? "is empty; give a value or leave the option out" : "";
}

/// Rejects NaN as the value of an option, which CLI11's bounds accept. Returns the message.
inline std::string refuse_nan(const std::string& text) {
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? "is not a number" : "";
}

/// Adds the required argument of a command that takes a scene.
inline void add_scene(CLI::App& command, std::string& scene) {
  command
      .add_option("scene", scene,
                  "Scene file, - for standard input, library mechanism (its scene), or scalable "
                  "case with its units, such as truck_suspension:5")
      ->required();
}

AddCommand add_list, add_show, add_inspect, add_solve, add_view, add_range, add_tune;
inline constexpr AddCommand* commands[] = {add_list, add_show,  add_inspect, add_solve,
                                           add_view, add_range, add_tune};

}  // namespace desmo::cli
