#pragma once

#include <regex>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/id.h"

namespace desmo::accuracy {

/// Configurations that solve the same motion and are timed in turn.
struct AccuracySeries {
  const Case* definition;
  int coordinates;
  double step;   ///< time between instants [s]
  int instants;  ///< number of instants, from the motion's beginning
  std::vector<Configuration> configurations;
};

/// Returns all series to measure. Sizes are those of Case::sizes.
/// - Every size: each formulation with the reduced grid. Dense global ones, whose steps cost O(n³),
///   have the minimal grid and fewer instants.
/// - Largest size: some formulations with the full grid.
/// - Largest size: formulations of the paper's Table 2. Each tolerance, each guess and each time
///   step is varied alone, from the default settings.
/// A quick run measures only the formulations with the full grid, with the reduced grid and at the
/// smallest size.
///
/// filter: pattern to find in <case>/<coordinates>/<id>. Configurations without it are left out,
/// and so are series that it leaves empty.
std::vector<AccuracySeries> make_series(bool quick, const std::regex& filter);

}  // namespace desmo::accuracy
