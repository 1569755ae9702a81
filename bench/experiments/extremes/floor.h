#pragma once

#include <span>

#include "formulations/scaling/scales.h"
#include "formulations/verification/condition.h"

namespace desmo::extremes {

/// The error that conditioning lets double precision reach in a position, relative to natural
/// magnitudes: accuracy_limit, for as many units of roundoff as the largest driver has turns of 1
/// rad, or lengths of the mechanism's size, since its own rounding cannot be undone.
PerLevel<double> floor_at(const Model& model, std::span<const double> q, double condition);

}  // namespace desmo::extremes
