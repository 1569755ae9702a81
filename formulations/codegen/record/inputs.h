#pragma once

#include <map>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// The inputs that move among those an expression reads, ascending by node.
std::vector<Expr> moving_inputs(Expr e);

/// Whether it reads one of these inputs.
bool reads(Expr e, const std::vector<Expr>& inputs);

/// The expression with other expressions in the place of some inputs, given by their nodes.
Expr substitute(Expr e, const std::map<int, Expr>& by_input);

}  // namespace desmo::generate
