#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/fuzz/grammar.h"
#include "tests/random.h"

namespace desmo::fuzz {

/// A mechanism or scene file that mutations start from.
struct Sample {
  std::string name;
  std::string text;
};

/// Loads the library's mechanisms and scenes, the scenes again with their mechanism inserted, the
/// scenes of cases/requests, and load_folder(folder).
std::vector<Sample> load_corpus(const std::filesystem::path& folder);

/// Loads the JSON files of a folder, without its subfolders, in alphabetical order. Throws
/// std::runtime_error when there is none.
std::vector<Sample> load_folder(const std::filesystem::path& folder);

/// Returns an input made of the documents of a corpus and random numbers alone.
std::string mutated(const std::vector<Json>& documents, Random& random);

/// Returns the text with the number of axles or dyads of a generated mechanism limited to `most`.
std::string with_few_units(std::string text, int most);

}  // namespace desmo::fuzz
