#pragma once

#include <vector>

#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

/// An equation, with the rows of the part that it follows from.
struct Said {
  Expr equation;
  std::vector<int> rows;
};

/// An irreducible block: n equations for n unknowns that must be solved together.
struct Block {
  std::vector<int> unknowns;  ///< inputs of the part
  std::vector<Said> equations;
};

/// Returns the irreducible blocks of a part's equations in solution order. Throws
/// std::invalid_argument when the equations are structurally singular.
std::vector<Block> blocks_of(const PartType& type, const RecordedPart& part);

}  // namespace desmo::generate
