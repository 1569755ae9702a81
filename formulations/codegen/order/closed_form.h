#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/record/differentiation.h"

namespace desmo::generate {

/// A choice between two solutions, such as the sign of a square root. It is kept from step to step.
struct Root {
  Expr branch;  ///< input: −1 when pivot < 0 at an earlier position, else +1
  Expr pivot;   ///< expression whose sign differs between the two solutions
};

/// A condition for trusting a closed form at run time: value > bound · against.
struct SizeMonitor {
  Expr value;
  double bound;
  Expr against;
};

/// All conditions for trusting a closed form, or the linear system of a core (see OrderSection).
struct Monitors {
  std::vector<SizeMonitor> sizes;
  std::vector<PivotMonitor> pivots;
};

/// The solution of a few equations for as many unknowns without iteration.
struct ClosedForm {
  std::string rule;  ///< name for comments and reports: "two circles"

  std::vector<Expr> values;  ///< positions of the unknowns; empty when `bearing` is set
  /// A vector (x, y) along (cos θ, sin θ) of the only unknown θ. The angle θ is atan2(y, x), plus
  /// the whole turns that bring it nearest to its last value.
  struct Bearing {
    Expr x, y;
  };
  std::optional<Bearing> bearing;

  std::vector<Root> roots;
  Monitors monitors;
  int cost = 0;  ///< relative run time: about two for a square root or a division
  /// Facts that the solution implies in addition to its equations: pairs of an expression and its
  /// value, such as the square of a square root.
  std::vector<std::pair<Expr, Expr>> consequences;

  /// Returns the velocities or the accelerations of the unknowns. In its argument, the unknowns'
  /// own rates of that level must be zero.
  std::function<std::vector<Expr>(const Rates&, Level)> rates;
};

/// Values of expressions that equations already solved imply, such as u·u = 1.
class Facts {
 public:
  /// Adds an equation e = 0 that holds.
  void learn(Expr e);
  /// Adds e = value.
  void learn(Expr e, Expr value);
  /// Returns the known value of e, or e itself.
  Expr value(Expr e) const;

 private:
  std::map<int, Expr> known_;
};

/// A task: n equations to solve for n unknowns x, which are inputs of the graph.
struct Task {
  std::vector<Expr> x, equations;
  const Facts& facts;
};

/// Rules, each in a file of closed_forms/. They return a closed form, or nullopt when they do not
/// apply.
std::optional<ClosedForm> solve_linear(const Task& task);
std::optional<ClosedForm> solve_sphere(const Task& task);
std::optional<ClosedForm> solve_direction_and_length(const Task& task);
std::optional<ClosedForm> solve_angle(const Task& task);

/// Solves a task by the first rule that applies; nullopt when none does.
std::optional<ClosedForm> solve_closed(const Task& task);

/// Sets form.rates by J ẋ = −Φ̇ and J ẍ = −Φ̈, where J = ∂Φ/∂x. Φ̇ and Φ̈ are the total derivatives
/// in which ẋ, or ẍ, is set to zero. solve: returns x with J x = b.
void rates_by_equations(ClosedForm& form, std::vector<Expr> equations,
                        std::function<std::vector<Expr>(const std::vector<Expr>& b)> solve);

/// Returns the closed form of an angle θ whose bearing (x, y) satisfies x² + y² = radius2. Its
/// rates are those of atan2(y, x).
ClosedForm angle_by_bearing(std::string rule, ClosedForm::Bearing bearing, Expr radius2);

/// Adds an input for the branch of a root and returns it. At each sample point it is −1 where the
/// pivot is negative, else +1.
Expr branch_of(Expr pivot);

/// Returns `form` written as +x or −x, with its rates, where x are the unknowns of an earlier
/// closed form. The values must agree up to sign on every branch, as for two vectors normal to the
/// same two others. Returns nullopt otherwise.
std::optional<ClosedForm> as_earlier_or_opposite(const ClosedForm& form, const ClosedForm& earlier,
                                                 const std::vector<Expr>& x);

/// Returns e with the absolute value of each term, as a measure of its rounding errors.
Expr magnitude(Expr e);

}  // namespace desmo::generate
