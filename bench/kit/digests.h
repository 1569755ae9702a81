#pragma once

#include <cstdint>
#include <string>

#include "formulations/model/model.h"

namespace desmo::bench {

/// Returns the SHA-256 that tells one model from another. It covers:
/// - name and unit of length
/// - entities: kind, group, fixed values, initial estimate
/// - constraints: name of the kind, operands, constants, group, rows left out
/// - groups and their order, and the drivers' motions
///
/// Names of entities, constraints, groups and bodies do not count. Values are rounded to 9 decimals
/// of their unit, the allowed difference of positions. So the last bit of a sine, which is the
/// compiler's and the C library's choice, makes no other model of it.
std::string model_digest(const Model& model);

/// Returns the multiple of `unit` nearest to a value. A value within one unit of the reference
/// counts as the reference, so all such values have the same multiple. A value farther away has
/// another multiple than the reference. NaN, and all values whose magnitude exceeds 10¹⁸ units,
/// have one common multiple.
std::int64_t nearest_multiple(double value, double reference, double unit);

}  // namespace desmo::bench
