#pragma once

#include <string>
#include <vector>

#include "formulations/codegen/order/closed_form.h"
#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

/// One or a few unknowns defined in closed form by what stands before.
struct Definition {
  ClosedForm form;
  std::vector<int> unknowns;         ///< inputs of the part
  std::vector<std::string> because;  ///< the equations it satisfies
};

/// A section of the explicit order: definitions and, where it is a core, the torn unknowns before
/// them and the residuals that Newton–Raphson brings to zero. Every definition of a core is needed
/// for its residuals.
struct OrderSection {
  std::vector<int> torn;  ///< inputs of the part
  std::vector<Definition> definitions;
  std::vector<Expr> residuals;
  std::vector<std::vector<int>> residual_rows;  ///< of which equations each is made
  std::vector<std::string> residual_names;
};

/// The unknowns of a part one after the other: its irreducible blocks in order, each in closed form
/// or torn to a small core.
std::vector<OrderSection> explicit_order(const PartType& type, const RecordedPart& part);

}  // namespace desmo::generate
