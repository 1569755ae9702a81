#pragma once

#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/verification/certificate/block_equations.h"
#include "formulations/verification/certificate/preconditioner.h"

namespace desmo {

/// Up to four independent blocks of one shape, which are certified at once, each in a lane. Lanes
/// without a block repeat the first. In vectors of indices, number k of lane l is at 4 k + l.
struct BlockBatch {
  /// A block, and where its errors are kept.
  struct PlacedBlock {
    ShapedBlock block;
    GroupId group;
    int order;              ///< position among all blocks in solution order
    Level solved;           ///< level up to which it is solved
    std::vector<int> rows;  ///< row of each column in ErrorTable
  };

  /// - of_lanes: 1 to 4, independent and of one shape
  /// - magnitudes: of each coordinate, for trial boxes X and the condition number
  /// - columns: largest number of symbols in ErrorTable, which `rounding` counts
  BlockBatch(std::span<const PlacedBlock> of_lanes, const std::vector<double>& magnitudes,
             int columns);

  int size() const { return static_cast<int>(blocks.size()); }
  /// Returns the block in a lane; lane < LaneNumbers::count.
  const PlacedBlock& in_lane(int lane) const { return blocks[lane < size() ? lane : 0]; }

  std::vector<PlacedBlock> blocks;
  BlockEquations equations;
  std::vector<int> plain;               ///< local states that are unknowns or fixed
  std::vector<int> states;              ///< position of each plain one in the model's state
  std::vector<int> coordinates;         ///< the model's, of each column and lane
  std::vector<int> rows;                ///< row in ErrorTable of each column and lane
  std::vector<int> locals;              ///< local state of each column, the same in all lanes
  std::vector<LaneNumbers> magnitudes;  ///< of each column
  double rounding;                   ///< bound on all relative rounding, counted in block_image.cpp
  LaneMatrix jacobian;               ///< Φ_q where it was evaluated last
  Preconditioner constant;           ///< of a linear block; otherwise empty
  LaneNumbers condition;             ///< of a linear block (Preconditioner::condition)
  std::vector<LaneNumbers> initial;  ///< Φ₀ of a homotopy (n); empty: none
};

/// Maxima of each size over some batches, for which memory is allocated.
struct BatchSizes {
  int unknowns = 0, width = 0, states = 0;
  int columns = 0;  ///< symbols of ErrorTable
};

}  // namespace desmo
