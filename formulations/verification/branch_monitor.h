#pragma once

#include <vector>

#include "formulations/base/observer.h"
#include "formulations/planning/plan.h"

namespace desmo {

/// Watches what solved positions must satisfy beyond the equations that were solved:
/// - an angle that its equation tells modulo π only (holds_modulo_pi) is the one meant, not one
/// half
///   a turn away, and has not turned by more than that since the last instant, or the estimate:
///   where a large step can end;
/// - the equations that were left out as dependent (Constraint::left_out) hold: they follow from
///   others nearly everywhere, but may not in single positions or on another branch.
/// Instants come in order of time. The plan must outlive the monitor.
class BranchMonitor {
 public:
  /// tolerance: to which positions are solved (Settings).
  BranchMonitor(const Plan& plan, double tolerance);

  /// A constraint of the plan's mechanism that a solved instant does not satisfy in this sense, in
  /// position or, as far as it was solved, in velocity, to 1e-6 of what its equations add up, or a
  /// thousand times a coarser tolerance, a tenth at most; -1: none. Interpolated instants are not
  /// looked at: another branch shows where one is solved.
  int violated(const Instant& instant);

 private:
  const Plan& plan_;
  double allowed_;                    // of what an equation adds up
  std::vector<int> watched_;          // constraints
  std::vector<double> state_, rate_;  // q and the fixed components, and their rates
  std::vector<double> last_;          // q of the last instant, or the estimate
  std::vector<bool> driven_;          // coordinates
};

}  // namespace desmo
