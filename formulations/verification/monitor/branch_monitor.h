#pragma once

#include <array>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns whether the equations left out of a constraint hold wherever some other constraint of
/// its group does. The length of a link, for example, follows from the definition of its angle.
/// Such equations need not be checked on any branch. Decided numerically, at random positions.
bool is_implied(const Model& model, const Constraint& constraint);

/// Checks conditions that solved positions must satisfy beyond the equations that were solved:
/// - An angle that its equation determines modulo π only (holds_modulo_pi) is the declared one, not
///   the one half a turn away. It has turned by at most π since the last instant or the initial
///   estimate: a large step can end elsewhere.
/// - The equations left out as dependent (Constraint::left_out) hold. They follow from the others
///   nearly everywhere, but perhaps not in single positions or on another branch.
class BranchMonitor {
 public:
  /// levels: the level up to which each coordinate is solved (Plan::levels); empty: all levels.
  /// tolerance: the one of positions. The model must outlive the monitor; levels are copied.
  BranchMonitor(const Model& model, std::span<const Level> levels, double tolerance);

  /// Returns a constraint that a solved instant violates, or -1. Velocities are checked as far as
  /// they were solved. A constraint is violated when it is off by more than max(1e-6, 1000 ×
  /// tolerance), at most a tenth, of its magnitude and the sum of its terms. Instants come in order
  /// of time. Interpolated ones are not checked: another branch shows at the solved ones.
  /// angles_follow: no angle is half a turn from where the last instant leads it, by its rates. So
  /// the angles are not checked, nor equations that cannot fail alone (is_implied).
  int violated(const Instant& instant, bool angles_follow = false);

 private:
  struct Check {
    int constraint;
    bool has_rate;                       // of all its operands
    int angle = -1;                      // coordinate that is determined modulo π, unless driven
    std::array<double, 3> magnitudes{};  // natural ones of its equations
  };
  bool holds(const Check& check, const Instant& instant) const;

  const Model& model_;
  double allowed_;                      // relative to the sum of an equation's terms
  std::vector<Check> always_, others_;  // others_: unless angles follow
  std::vector<int> angles_;             // of all checks
  std::vector<double> last_;            // q of the last instant, or the initial estimate
};

}  // namespace desmo
