#pragma once

#include <vector>

#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

/// What the code of a section computes beside its definitions.
struct SectionMotion {
  std::vector<Expr> increments;      ///< of Newton–Raphson on the torn unknowns, to be subtracted
  std::vector<PivotMonitor> pivots;  ///< of the core's elimination
  std::vector<SizeMonitor> sizes;    ///< of its determinant, where that serves
  /// Of its torn unknowns and then those defined, in order: rates as expressions of earlier ones.
  std::vector<Expr> velocities, accelerations;
};

/// Newton–Raphson, velocities and accelerations of an explicit order, by differentiating its
/// definitions. With torn unknowns τ and all else x(τ): dx/dτ follows from definition to
/// definition, gives the core's matrix ∂R/∂τ, and serves x' = x'|τ'=0 + dx/dτ τ' at both levels of
/// rates.
std::vector<SectionMotion> differentiate(const RecordedPart& part,
                                         const std::vector<OrderSection>& order);

/// Its unknowns: torn, then defined.
std::vector<int> unknowns_of(const OrderSection& section);

}  // namespace desmo::generate
