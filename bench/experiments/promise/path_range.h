#pragma once

#include <array>
#include <vector>

#include "bench/experiments/promise/mechanisms.h"
#include "formulations/model/model.h"

namespace desmo::promise {

/// Ranges of drivers that go straight from the nominal position.
struct PathRange {
  struct End {
    double at;      ///< path parameter, with the sign of the side
    bool singular;  ///< a singular position; otherwise nothing is in the way up to there
  };
  std::vector<double> nominal;  ///< of the drivers
  std::array<End, 2> ends;      ///< backwards, forwards
};

/// Follows the path in quadruple precision to the first singular position on both sides. Throws
/// std::runtime_error when there is no nominal position.
PathRange find_range(const Model& model, const Drawn& drawn);

}  // namespace desmo::promise
