#pragma once

#include <array>
#include <vector>

#include "formulations/model/model.h"
#include "tests/properties/mechanisms.h"

namespace desmo::properties {

/// Ranges of drivers that go straight from the nominal position.
struct PathRange {
  struct End {
    double at;      ///< path parameter, with the sign of the side
    bool singular;  ///< a singular position; otherwise nothing is in the way up to there
  };
  std::vector<double> nominal;  ///< values of the drivers where it begins
  std::array<End, 2> ends;      ///< backwards, forwards
};

/// Follows the path in quadruple precision to the first singular position on both sides, from the
/// model's estimate. Throws std::runtime_error where that is no position.
PathRange find_range(const Model& model, const Drawn& drawn);

}  // namespace desmo::properties
