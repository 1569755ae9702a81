#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/record/differentiation.h"

namespace desmo::generate {

/// A square root whose sign is the assembly branch: kept from the last position, as state.
struct Root {
  Expr branch;  ///< an input: +1 or −1 …
  Expr pivot;   ///< … the sign of this at the last position
};

/// value > bound · against, or the closed form is not trusted.
struct SizeMonitor {
  Expr value;
  double bound;
  Expr against;
};

/// How one or a few unknowns follow from as many equations, all else known.
struct ClosedForm {
  std::string rule;  ///< for comments and reports: "two circles"

  std::vector<Expr> values;  ///< of the unknowns, in order; of an angle: see below
  /// Of an angle θ, (x, y) along (cos θ, sin θ): the arctangent nearest to its last value.
  struct Bearing {
    Expr x, y;
  };
  std::optional<Bearing> bearing;

  std::vector<Root> roots;
  std::vector<SizeMonitor> sizes;
  std::vector<PivotMonitor> pivots;
  int cost = 0;  ///< square roots and divisions, in such units
  /// What the values make of other expressions, such as the square of a square root.
  std::vector<std::pair<Expr, Expr>> consequences;

  /// Velocities (accelerations) of the unknowns, given those of everything else; theirs must be
  /// zero in the rates given (second: their accelerations).
  std::function<std::vector<Expr>(const Rates&)> first, second;
};

/// What is known of expressions because equations already solved say so, such as u·u = 1.
class Facts {
 public:
  /// An equation e = 0 that holds.
  void learn(Expr e);
  void learn(Expr e, Expr value);
  /// What an expression is known to equal, or itself.
  Expr value(Expr e) const;

 private:
  std::map<int, Expr> known_;
};

/// Equations to be solved for as many unknowns x, given as inputs.
struct Task {
  std::vector<Expr> x, equations;
  const Facts& facts;
};

/// A rule: nothing when it does not apply. One file each in closed_forms/.
using Rule = std::optional<ClosedForm> (*)(const Task&);

std::optional<ClosedForm> solve_linear(const Task& task);
std::optional<ClosedForm> solve_sphere(const Task& task);
std::optional<ClosedForm> solve_direction_and_length(const Task& task);
std::optional<ClosedForm> solve_angle(const Task& task);

/// The first rule that applies.
std::optional<ClosedForm> solve_closed(const Task& task);

/// The unknowns' rates from those equations: J ẋ = −Φ̇ and J ẍ = −Φ̈ with the unknowns' own rates
/// zero, where solve gives x of J x = b.
void rates_by_equations(ClosedForm& form, std::vector<Expr> equations,
                        std::function<std::vector<Expr>(const std::vector<Expr>& b)> solve);

/// An angle from (x, y) along (cos θ, sin θ), of which x² + y² = radius2 is known: both rates by
/// differentiating atan2.
ClosedForm angle_by_bearing(std::string rule, ClosedForm::Bearing bearing, Expr radius2);

/// An input for the sign of a root's pivot, sampled where the unknowns are.
Expr branch_of(Expr pivot);

/// What rounding errors of an expression are relative to: its sums without cancellation.
Expr magnitude(Expr e);

}  // namespace desmo::generate
