#pragma once

#include <string>
#include <vector>

#include "formulations/codegen/order/closed_form.h"
#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

// An *explicit order* computes a part's unknowns one after the other in closed form. Where needed,
// some unknowns are *torn*: assumed, then corrected by Newton–Raphson.

/// The definition of one or a few unknowns in closed form, in terms of earlier ones.
struct Definition {
  ClosedForm form;
  std::vector<int> unknowns;         ///< numbers of these unknowns among the part's inputs
  std::vector<std::string> because;  ///< names of the equations that it satisfies
};

/// A section of the explicit order: one definition, or a *core*. A core has torn unknowns, the
/// definitions that its residuals need, and the residuals, which Newton–Raphson brings to zero.
struct OrderSection {
  std::vector<int> torn;  ///< torn unknowns, as inputs of the part; empty: not a core
  std::vector<Definition> definitions;
  std::vector<Expr> residuals;
  std::vector<std::vector<int>> residual_rows;  ///< rows of the equations each residual is made of
  std::vector<std::string> residual_names;
};

/// Returns the explicit order of a part: its irreducible blocks in solution order, each in closed
/// form or with a core. Throws std::invalid_argument when the equations are structurally singular,
/// or when a block has more than Tearing::max_unknowns unknowns.
std::vector<OrderSection> explicit_order(const PartType& type, const RecordedPart& part);

/// Returns the names of inputs as a list: "C.x, C.y".
std::string names_of(const PartType& type, const std::vector<int>& inputs);

}  // namespace desmo::generate
