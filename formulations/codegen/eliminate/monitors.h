#pragma once

#include <string>
#include <vector>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// What the conditions of these monitors are written with.
std::vector<Expr> monitored(const std::vector<PivotMonitor>& monitors);
std::vector<Expr> monitored(const std::vector<SizeMonitor>& monitors);

/// C++ conditions, each true while no pivot is far smaller beside its column than it was at any
/// sample point, or no value too small beside what it is made of. Everything monitored must have
/// been prepared.
std::vector<std::string> conditions(const Emitter& emitter,
                                    const std::vector<PivotMonitor>& monitors);
std::vector<std::string> conditions(const Emitter& emitter,
                                    const std::vector<SizeMonitor>& monitors);

/// The conjunction of conditions, without branches; "true" when there are none.
std::string all_of(const std::vector<std::string>& conditions);

}  // namespace desmo::generate
