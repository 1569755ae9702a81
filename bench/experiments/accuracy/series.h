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
  double step;   ///< s
  int instants;  ///< of the motion, from its beginning
  std::vector<Configuration> configurations;
};

/// Returns everything that is measured, series by series:
/// - every formulation at every size with the reduced grid; dense global ones, whose steps cost
///   O(n³), with the minimal one and over fewer instants;
/// - at the largest size of the tables, some formulations with the full grid, and those of the
///   paper's Table 2 with each tolerance and guess, and with each time step.
/// In a quick run these are the formulations of the full grid at the smallest size, with the
/// reduced one.
///
/// filter: only configurations in whose <case>/<coordinates>/<id> it is found; series with none are
/// left out.
std::vector<AccuracySeries> make_series(bool quick, const std::regex& filter);

}  // namespace desmo::accuracy
