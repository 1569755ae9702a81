#pragma once

#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

/// Trial boxes X of a block, each larger than the one before. A contraction of 0.8 needs ten.
inline constexpr int max_trial_boxes = 10;

/// Smallest radius of X, over the magnitude of its coordinate: in its last digits.
inline constexpr double min_trial = 0x1p-50;

/// Returns the radius of the next X from the image of the last one: somewhat larger (epsilon
/// inflation; Rump), also where that is zero.
inline LaneNumbers inflated(const LaneNumbers& image, const LaneNumbers& magnitude) {
  constexpr double growth = 1.1;
  return fma(magnitude, min_trial, image * growth);
}

}  // namespace desmo
