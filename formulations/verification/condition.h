#pragma once

#include <memory>
#include <span>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"

namespace desmo {

/// Computes the condition number of a model's equations at a position: ‖A⁻¹‖∞ of A = R⁻¹ Φ_φ S, all
/// equations at once. S holds the nominal magnitudes of the unknowns: one radian, or a length of
/// the mechanism. R makes the row sums of |A| one, so that ‖A‖∞ = 1. The number bounds the relative
/// change of position that a relative change of an equation causes, whatever the units and the
/// partition. The inverse is not estimated: n solves with a sparse LU factorisation, O(n²).
class ConditionNumber {
 public:
  /// Analyses the model, which must outlive this object.
  explicit ConditionNumber(const Model& model);
  explicit ConditionNumber(const Model&& model) = delete;
  ~ConditionNumber();

  /// Returns the condition number at positions q, in coordinate order; infinity where Φ_φ is
  /// singular in double precision.
  double operator()(std::span<const double> q);

 private:
  struct Matrix;
  std::unique_ptr<Matrix> matrix_;
};

/// Returns the order of the relative error that conditioning allows: κ u in position, κ² u in
/// velocity, κ³ u in acceleration. u is the scalar's unit roundoff, 2⁻⁵³ for double, 2⁻²⁴ for
/// float. Each level divides once more by Φ_φ, which depends on the erroneous level before.
inline PerLevel<double> accuracy_limit(double condition, double u) {
  return {condition * u, condition * condition * u, condition * condition * condition * u};
}

}  // namespace desmo
