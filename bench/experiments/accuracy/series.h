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
  int instants;  ///< of the motion, from its begin
  std::vector<Configuration> configurations;
};

/// Returns everything that is measured, series by series:
/// - every formulation at every size with the reduced grid; dense global ones, whose steps cost
///   O(n³), with the minimal one and over fewer instants;
/// - at the largest size of the tables, some formulations with the full grid, and those of the
///   paper's Table 2 with each tolerance and guess, and with each time step.
std::vector<AccuracySeries> all_series();

/// Returns the formulations of the full grid at the smallest size, with the reduced one.
std::vector<AccuracySeries> quick_series();

/// Returns the series without the configurations in whose <case>/<coordinates>/<id> the expression
/// is not found; series with none are left out.
std::vector<AccuracySeries> matching(std::vector<AccuracySeries> all, const std::regex& expression);

}  // namespace desmo::accuracy
