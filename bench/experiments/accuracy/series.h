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

/// Returns everything that is measured, series by series:
/// - every formulation at every size with the reduced grid; dense global ones, whose steps cost
///   O(n³), with the minimal one and over fewer instants;
/// - at the largest size of the tables, some formulations with the full grid, and those of the
///   paper's Table 2 with each tolerance and guess, and with each time step.
/// In a quick run, only the formulations that otherwise have the full grid are measured, with the
/// reduced grid at the smallest size.
///
/// filter: found in <case>/<coordinates>/<id> of each configuration returned; series without any
/// are left out.
std::vector<AccuracySeries> make_series(bool quick, const std::regex& filter);

}  // namespace desmo::accuracy
