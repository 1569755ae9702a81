#pragma once

#include <span>
#include <vector>

#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"

namespace desmo {

/// Solves a motion at ascending instants [s] in double precision, group by group with dense
/// matrices: reference_solution() with Precision::standard, for programs without quadruple
/// precision. Throws std::runtime_error, naming the group and the instant, when Newton's method
/// does not converge.
std::vector<ReferenceInstant> double_solution(const Model& model, std::span<const double> times);

}  // namespace desmo
