#pragma once

#include <memory>
#include <span>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"

namespace desmo {

/// The condition number of a mechanism's equations in a position: ‖A⁻¹‖∞ of A = R⁻¹ Φ_φ S, all
/// equations at once, where S holds the natural magnitudes of the unknowns (see natural_magnitudes)
/// and R makes the row sums of |A| one, so that ‖A‖∞ = 1. It says by how much a relative change of
/// an equation changes the position relative to the size of the mechanism, whatever the units and
/// the partition. The inverse is computed, n solves with a sparse LU factorisation: exact, and
/// O(n²), for hundreds of coordinates.
class ConditionNumber {
 public:
  /// The mechanism must outlive it.
  explicit ConditionNumber(const Model& model);
  ~ConditionNumber();

  /// q: positions in coordinate order. Infinite where Φ_φ is singular in double precision.
  double operator()(std::span<const double> q);

 private:
  struct Matrices;
  std::unique_ptr<Matrices> matrices_;
};

/// The relative error that conditioning lets a scalar of unit roundoff u reach (2⁻⁵³ for
/// double, 2⁻²⁴ for float), as a prediction of its order: κ u in position, κ² u in velocity, κ³ u
/// in acceleration. Each level divides once more by Φ_φ, which depends on the erroneous level
/// before.
inline PerLevel<double> accuracy_limit(double condition, double u) {
  return {condition * u, condition * condition * u, condition * condition * condition * u};
}

}  // namespace desmo
