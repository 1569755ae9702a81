#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

/// The Newton–Raphson increments and the rates of a section of the explicit order (see
/// OrderSection).
struct SectionMotion {
  std::vector<Expr> increments;  ///< Δτ of the torn unknowns, to be subtracted
  Monitors monitors;             ///< conditions for trusting the core's linear system
  /// Expressions of the rates: torn unknowns first, then defined ones. They read rates of earlier
  /// sections; those of defined unknowns read the rates of torn ones, too.
  std::vector<Expr> velocities, accelerations;
};

/// Differentiates the definitions of an explicit order. With torn unknowns τ, defined unknowns x(τ)
/// and residuals R, the chain rule gives dx/dτ and the core's matrix dR/dτ. Velocities are
/// ẋ = ẋ|τ̇=0 + dx/dτ τ̇, and accelerations likewise.
std::vector<SectionMotion> differentiate(const RecordedPart& part,
                                         const std::vector<OrderSection>& order);

/// Returns the unknowns of a section: torn, then defined.
std::vector<int> unknowns_of(const OrderSection& section);

/// The data from which the functions of one explicit kernel are written.
struct ExplicitPlan {
  /// Finds the explicit order and its rates in the current graph. type and part must outlive the
  /// plan.
  ExplicitPlan(const PartType& type, const RecordedPart& part);

  const PartType& type;
  const RecordedPart& part;
  std::vector<OrderSection> order;
  std::vector<SectionMotion> motion;  ///< increments and rates of each section of the order
  /// Squared norm of each section's residuals, each times the weights of its equations.
  std::vector<Expr> residual2;
  std::vector<Root> roots;  ///< roots of all definitions, in the order of these
  /// C++ text that reads a position or rate, by node: "q[in[3]]".
  std::map<int, std::string> places;

  /// Returns the expressions that the positions of a section and their monitors are written from.
  std::vector<Expr> position(std::size_t section) const;
  /// Returns the expressions that the whole function `solve` is written from.
  std::vector<Expr> expressions() const;
};

/// Writes the function `solve` of an explicit kernel, a template on value type and level. It
/// computes positions, residuals of the original equations, monitors and rates. Returns the
/// expressions of dimensions alone. The function reads their values in its array `f`, which is
/// computed once for a mechanism (ExplicitKernel::fold).
std::vector<Expr> write_solve(std::ostream& out, const ExplicitPlan& plan);

}  // namespace desmo::generate
