#pragma once

#include <vector>

#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

/// An equation, and the rows of the part that it says.
struct Said {
  Expr equation;
  std::vector<int> rows;
};

/// As many equations as unknowns, none of which can be solved without the others.
struct Block {
  std::vector<int> unknowns;  ///< inputs of the part
  std::vector<Said> equations;
};

/// The irreducible blocks of a part's equations, in the order in which they can be solved. Throws
/// std::invalid_argument when the equations are structurally singular.
std::vector<Block> blocks_of(const PartType& type, const RecordedPart& part);

}  // namespace desmo::generate
