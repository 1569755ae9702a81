#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/corpus.h"
#include "tests/fuzz/random.h"
#include "tests/fuzz/tree.h"

namespace desmo::fuzz {

/// Makes inputs of a corpus. What it makes depends on the random numbers alone.
class Mutator {
 public:
  explicit Mutator(const std::vector<Sample>& corpus);

  std::string make(Random& random) const;

 private:
  Tree spliced(Tree tree, Random& random) const;

  std::vector<Tree> trees_;
};

/// The text with the units of a scalable mechanism cut down to `most`: size is tested elsewhere.
std::string with_few_units(std::string text, int most);

}  // namespace desmo::fuzz
