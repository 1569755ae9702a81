#pragma once

#include <span>

#include "cases/mechanism.h"
#include "formulations/accuracy/scales.h"
#include "formulations/accuracy/wide_instant.h"

namespace desmo {

/// Largest difference of two solutions at the same instants, over all outputs (see ErrorMeasure),
/// relative to the scales; taken in quadruple precision.
PerLevel<double> disagreement(const Mechanism& mechanism, std::span<const WideInstant> a,
                              std::span<const WideInstant> b, const Scales& scales);

}  // namespace desmo
