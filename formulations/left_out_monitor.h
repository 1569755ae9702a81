#pragma once

#include <vector>

#include "formulations/formulation.h"
#include "formulations/plan.h"

namespace desmo {

/// Watches the equations that were left out of a constraint as dependent while others of it were
/// kept (Constraint::left_out). What is left of, say, the definition of an angle can hold on
/// another branch than the whole, and is singular in single positions: there, solved positions or
/// velocities do not satisfy the equations left out. The plan must outlive the monitor.
class LeftOutMonitor {
 public:
  explicit LeftOutMonitor(const Plan& plan);

  /// A constraint of the plan's mechanism whose left-out equations a solved instant does not
  /// satisfy, in position or, as far as it was solved, in velocity, to 1e-6 of what they add up;
  /// -1: none.
  int violated(const Instant& instant);

 private:
  const Plan& plan_;
  std::vector<int> watched_;          // constraints with something left out
  std::vector<double> state_, rate_;  // q and the fixed components, and their rates
};

}  // namespace desmo
