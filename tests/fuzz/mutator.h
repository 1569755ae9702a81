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

/// A generator of inputs from a corpus, which depend on the random numbers alone.
class Mutator {
 public:
  explicit Mutator(const std::vector<Sample>& corpus);

  std::string make(Random& random) const;

 private:
  void splice(Json& root, Random& random) const;

  Grammar grammar_;
  std::vector<Json> documents_;
};

/// Returns the text with the number of axles or dyads of a generated mechanism limited to `most`.
std::string with_few_units(std::string text, int most);

}  // namespace desmo::fuzz
