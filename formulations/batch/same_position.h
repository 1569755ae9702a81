#pragma once

#include <span>

#include "formulations/model/model.h"

namespace desmo {

/// Whether two solutions of one instant are the same position: converged, they differ by far less
/// than is allowed, and on different assembly branches by far more. a, b: in coordinate order.
bool same_position(const Model& model, std::span<const double> a, std::span<const double> b);

}  // namespace desmo
