#pragma once

#include <string>
#include <vector>

#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// Returns the expressions that the conditions of these monitors contain.
std::vector<Expr> monitored(const Monitors& monitors);

/// Returns the monitors as C++ conditions, each true while the pivot or value can be trusted. The
/// emitter must have prepared all expressions that monitored() returns.
std::vector<std::string> conditions(const Emitter& emitter, const Monitors& monitors);

/// Joins conditions by `&`, which does not branch; "true" when there are none.
std::string all_of(const std::vector<std::string>& conditions);

}  // namespace desmo::generate
