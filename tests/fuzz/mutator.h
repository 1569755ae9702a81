#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/corpus.h"
#include "tests/fuzz/random.h"
#include "tests/fuzz/tree.h"

namespace desmo::fuzz {

/// A generator of inputs from a corpus, which depend on the random numbers alone.
class Mutator {
 public:
  explicit Mutator(const std::vector<Sample>& corpus);

  std::string make(Random& random) const;

 private:
  Tree spliced(Tree tree, Random& random) const;

  std::vector<Tree> trees_;
};

/// Returns the text with the number of axles or dyads of a generated mechanism limited to `most`.
std::string with_few_units(std::string text, int most);

}  // namespace desmo::fuzz
