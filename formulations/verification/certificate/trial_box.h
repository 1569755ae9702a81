#pragma once

#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/preconditioner.h"

namespace desmo {

/// Maximum number of trial boxes X of a block, each larger than the one before (inflated()). Let
/// A = |I − Y Φ_φ| hardly depend on X. Ten boxes then prove a path with A X ≤ 0.9 X. They prove an
/// instant, whose test wants A X < X/2, with A X ≤ 0.44 X.
inline constexpr int max_trial_boxes = 10;

/// Radius of the first X of a certificate over the magnitude of its coordinate. It exceeds the
/// usual errors, so that one evaluation will do. Its square is far below the roundoff u, so that it
/// costs no digits.
inline constexpr double first_trial = 0x1p-36;

/// Returns the radius of the next X: 1.1 × the image of the last X (epsilon inflation; Rump) plus
/// u × the magnitude of the coordinate. The second term keeps the radius above zero, since
/// BlockProof::bound_rates() divides by it.
inline LaneNumbers inflated(const LaneNumbers& image, const LaneNumbers& magnitude) {
  constexpr double growth = 1.1;
  return fma(magnitude, Interval::unit, image * growth);
}

/// Bounds |(I − Y Φ_φ(X)) X| of a batch, whose `jacobian` is Φ_φ(X). All are (n).
/// - trial: radii of X
/// - uncertainty: workspace; overwritten
/// - contracted: the bound; overwritten. The top of block_image.cpp says what rounding is in it
void contract(const BlockBatch& batch, const Preconditioner& y, const LaneNumbers* trial,
              LaneNumbers* uncertainty, LaneNumbers* contracted);

}  // namespace desmo
