#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/generators/cases.h"

namespace desmo::instructions {

/// Instructions of a step of one formulation.
struct StepCount {
  std::string case_name;
  int coordinates;
  std::string id;                 ///< with monitored_suffix where the run is monitored
  std::int64_t instructions = 0;  ///< per step, with as many Newton iterations as it takes
  int steps = 0;                  ///< that were counted

  std::string name() const;  ///< <case>/<coordinates>/<id>
};

/// What is counted, not counted yet: of both cases, at so many coordinates or (0) at the largest of
/// the paper's sizes, everything but blocks, dense global solves and SPQR, what goes beyond the
/// paper, and what it costs to monitor a run. Throws std::invalid_argument, saying which sizes
/// exist, when one has not that many.
std::vector<StepCount> to_be_counted(int coordinates);

/// Counts with the program desmo_steps, as count_steps does. Throws std::runtime_error, naming the
/// formulation, when one cannot be counted.
void count(std::vector<StepCount>& all, const std::string& desmo_steps);

}  // namespace desmo::instructions
