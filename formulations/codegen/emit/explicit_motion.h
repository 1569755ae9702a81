#pragma once

#include <vector>

#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

/// The Newton–Raphson increments and the rates of a section of the explicit order (see
/// OrderSection).
struct SectionMotion {
  std::vector<Expr> increments;      ///< Δτ of the torn unknowns, to be subtracted
  std::vector<PivotMonitor> pivots;  ///< monitors of the core's elimination
  std::vector<SizeMonitor> sizes;    ///< monitor of its determinant, for a core of two unknowns
  /// Rates of the torn, then of the defined unknowns, by earlier rates.
  std::vector<Expr> velocities, accelerations;
};

/// Differentiates the definitions of an explicit order. With torn unknowns τ, defined unknowns x(τ)
/// and residuals R, the chain rule gives dx/dτ and the core's matrix dR/dτ. Velocities are
/// ẋ = ẋ|τ̇=0 + dx/dτ τ̇, and accelerations likewise.
std::vector<SectionMotion> differentiate(const RecordedPart& part,
                                         const std::vector<OrderSection>& order);

/// Returns the unknowns of a section: torn, then defined.
std::vector<int> unknowns_of(const OrderSection& section);

}  // namespace desmo::generate
