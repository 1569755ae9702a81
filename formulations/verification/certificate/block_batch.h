#pragma once

#include <array>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/verification/certificate/block_equations.h"
#include "formulations/verification/certificate/preconditioner.h"

namespace desmo {

/// Up to four independent blocks of one shape, which are certified at once, each in a lane. Lanes
/// without a block repeat the first. Indices of lane l stand at 4 k + l.
struct BlockBatch {
  /// A block, and where its errors are kept.
  struct Member {
    ShapedBlock block;
    GroupId group;
    int order;              ///< position among all blocks in solution order
    Level solved;           ///< level up to which it is solved
    std::vector<int> rows;  ///< row of each column in ErrorTable
  };

  /// magnitudes: of coordinates, for the first X. columns: of ErrorTable.
  BlockBatch(std::span<const Member> blocks, const std::vector<double>& magnitudes, int columns);

  int blocks() const { return static_cast<int>(members.size()); }
  /// Returns what stands in a lane (LaneNumbers::count).
  const Member& in_lane(int lane) const { return members[lane < blocks() ? lane : 0]; }

  std::vector<Member> members;
  BlockEquations equations;
  std::vector<int> plain;               ///< local states of unknowns and of what is fixed
  std::vector<int> states;              ///< of each plain one, in the state of the model
  std::vector<int> coordinates;         ///< of each column
  std::vector<int> rows;                ///< of each column, in ErrorTable
  std::vector<int> locals;              ///< local state of each column, the same in all lanes
  std::vector<LaneNumbers> magnitudes;  ///< of each column
  double rounding;                   ///< bound on all relative rounding, counted in block_image.cpp
  LaneMatrix jacobian;               ///< Φ_q
  Preconditioner constant;           ///< of linear equations
  LaneNumbers condition;             ///< of these (Preconditioner::condition)
  std::vector<LaneNumbers> initial;  ///< Φ₀ of a homotopy (n); empty: none
};

/// Sizes of the largest of some batches, for which memory is allocated.
struct BatchSizes {
  int unknowns = 0, width = 0, states = 0;
  int columns = 0;  ///< of ErrorTable
};

}  // namespace desmo
