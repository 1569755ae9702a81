#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace desmo::properties {

/// Choice of what the program draws, from its command line.
struct Options {
  int scenes = 20;
  std::uint64_t seed = 1;
  int ids = 6;                    ///< formulations of each scene, other ones for each; 0: all
  std::optional<int> scene = {};  ///< this scene alone
  std::string id = {};            ///< in this formulation alone
  std::string failures = {};      ///< folder for files of scenes with findings; empty: none
};

/// Returns the options of this program.
Options& options();

}  // namespace desmo::properties
