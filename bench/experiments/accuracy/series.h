#pragma once

#include <regex>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/id.h"

namespace desmo::accuracy {

/// Configurations that solve the same motion and are timed in turn.
struct Series {
  const Case* definition;
  int coordinates;
  double step;   ///< s
  int instants;  ///< of the motion, from its begin
  std::vector<Configuration> configurations;
};

/// Everything that is measured, series by series:
/// - every formulation at every size with few settings; dense global ones, whose steps cost O(n³),
///   with the fewest and over fewer instants;
/// - at the largest size of the tables, some formulations with all settings, and those of the
///   paper's Table 2 with each tolerance and guess, and with each time step.
std::vector<Series> all_series();

/// The same at the smallest size only, and without the knobs in all their combinations.
std::vector<Series> quick_series();

/// What is left of them when only configurations are kept in whose <case>/<coordinates>/<id> the
/// expression is found; series with none are left out.
std::vector<Series> matching(std::vector<Series> all, const std::regex& expression);

}  // namespace desmo::accuracy
