#pragma once

#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"

namespace desmo {

/// Checks what solved positions must satisfy beyond the equations that were solved:
/// - An angle that its equation tells modulo π only (holds_modulo_pi) is the declared one, not the
///   one half a turn away, and has turned by at most π since the last instant, or the estimate: a
///   large step can end elsewhere.
/// - The equations that were left out as dependent (Constraint::left_out) hold. They follow from
///   others nearly everywhere, but may not in single positions or on another branch.
class BranchMonitor {
 public:
  /// levels: to which each coordinate is solved (Plan::levels); empty: all levels. tolerance: to
  /// which positions are solved. The model must outlive the monitor; levels are copied.
  BranchMonitor(const Model& model, std::span<const Level> levels, double tolerance);

  /// Returns a constraint of the model that a solved instant violates in position or, as far as it
  /// was solved, in velocity; -1: none. A constraint is violated when it is off by more than 1e-6
  /// of the sum of its terms, or a thousand times a coarser tolerance, a tenth at most. Instants
  /// come in order of time; interpolated ones are not checked, since another branch shows where an
  /// instant is solved.
  int violated(const Instant& instant);

 private:
  const Model& model_;
  const std::vector<Level> levels_;
  double allowed_;                    // relative to the sum of an equation's terms
  std::vector<int> checked_;          // constraints
  std::vector<double> state_, rate_;  // q and the fixed components, and their rates
  std::vector<double> last_;          // q of the last instant, or the estimate
  std::vector<bool> driven_;          // coordinates
};

}  // namespace desmo
