#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace desmo::fuzz {

/// A mechanism or scene file to start from.
struct Sample {
  std::string name;
  std::string text;
};

/// The library mechanisms, their scenes, these with the mechanism written in them, the scenes of
/// cases/requests, and the files of a folder (not of the folders in it), in alphabetical order.
std::vector<Sample> load_corpus(const std::filesystem::path& folder);

/// The JSON files of one folder, in alphabetical order. Throws std::runtime_error when there is
/// none.
std::vector<Sample> load_folder(const std::filesystem::path& folder);

}  // namespace desmo::fuzz
