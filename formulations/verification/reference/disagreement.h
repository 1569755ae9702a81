#pragma once

#include <span>

#include "formulations/model/model.h"
#include "formulations/model/scales.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo {

/// Returns the largest difference of two solutions at the same instants over all outputs (see
/// ErrorMeasure), relative to the scales. Differences are taken in quadruple precision.
PerLevel<double> disagreement(const Model& model, std::span<const WideInstant> a,
                              std::span<const WideInstant> b, const Scales& scales);

}  // namespace desmo
