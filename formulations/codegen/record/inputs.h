#pragma once

#include <map>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// Returns the positions and rates that an expression reads (not its dimensions), ascending by
/// node.
std::vector<Expr> moving_inputs(Expr e);

/// Returns whether an expression contains one of these nodes, which must depend on positions or
/// rates.
bool reads(Expr e, const std::vector<Expr>& nodes);

/// Returns the expression with some inputs replaced. by_input: replacement by node of the input.
Expr substitute(Expr e, const std::map<int, Expr>& by_input);

}  // namespace desmo::generate
