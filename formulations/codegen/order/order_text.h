#pragma once

#include <string>
#include <vector>

#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

/// Returns an explicit order as text, one line per definition: unknowns, rule, equations.
std::string describe(const PartType& type, const std::vector<OrderSection>& order);

/// Returns the names of inputs as a list: "C.x, C.y".
std::string names_of(const PartType& type, const std::vector<int>& inputs);

}  // namespace desmo::generate
