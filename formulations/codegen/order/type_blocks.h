#pragma once

#include <optional>
#include <vector>

#include "formulations/codegen/order/explicit_order.h"
#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

/// An equation, with the rows of the part's equations that it follows from.
struct EquationOfRows {
  Expr equation;
  std::vector<int> rows;
};

/// An irreducible block: n equations for n unknowns that must be solved together.
struct Block {
  std::vector<int> unknowns;  ///< numbers of its unknowns among the part's inputs
  std::vector<EquationOfRows> equations;
};

/// Returns the irreducible blocks of a part's equations in solution order. Throws
/// std::invalid_argument when the equations are structurally singular.
std::vector<Block> blocks_of(const PartType& type, const RecordedPart& part);

/// An angle eliminated from two equations of a block.
struct SeparatedAngle {
  EquationOfRows rest;  ///< the equation ‖c‖² − R² = 0, which replaces the two
  Definition angle;     ///< definition of the angle in terms of c
};

/// Eliminates an angle θ from the two equations of a block that contain it. Their form must be
/// M (cos θ, sin θ)ᵀ + c = 0. M is a known rotation or reflection times R; c does not contain θ.
/// Then ‖c‖ = R, and the direction of c gives θ. Returns nullopt when there are no two such
/// equations. angle: an unknown of the block.
std::optional<SeparatedAngle> separate_angle(const Block& block, int angle, const PartType& type,
                                             const RecordedPart& part);

}  // namespace desmo::generate
