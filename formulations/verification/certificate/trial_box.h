#pragma once

#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/preconditioner.h"

namespace desmo {

/// Trial boxes X of a block, each larger than the one before. A contraction of 0.8 needs ten.
inline constexpr int max_trial_boxes = 10;

/// Radius of the first X of a certificate relative to the magnitude of its coordinate: so large
/// that one evaluation will do, and so small that it costs no digits, for X² is far below a unit.
inline constexpr double first_trial = 0x1p-36;

/// Returns the radius of the next X from the image of the last one: somewhat larger (epsilon
/// inflation; Rump). Bounds of rates are divided by it, so it must not be zero: it has the rounding
/// of a number of the coordinate's magnitude, too.
inline LaneNumbers inflated(const LaneNumbers& image, const LaneNumbers& magnitude) {
  constexpr double growth = 1.1;
  return fma(magnitude, Interval::unit, image * growth);
}

/// Bounds |(I − Y Φ_φ(X)) X| of a batch, whose `jacobian` is Φ_φ(X). All are (n).
/// - trial: radii of X
/// - uncertainty: of the equations; overwritten
/// - contracted: the bound; overwritten. The top of block_image.cpp says what rounding is in it
void contract(const BlockBatch& batch, const Preconditioner& y, const LaneNumbers* trial,
              LaneNumbers* uncertainty, LaneNumbers* contracted);

}  // namespace desmo
