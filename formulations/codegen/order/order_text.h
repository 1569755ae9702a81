#pragma once

#include <string>
#include <vector>

#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

/// An explicit order as text, a line for each definition: what, by which rule, from which
/// equations.
std::string describe(const PartType& type, const std::vector<OrderSection>& order);

/// The names of inputs, "C.x, C.y".
std::string names_of(const PartType& type, const std::vector<int>& inputs);

}  // namespace desmo::generate
