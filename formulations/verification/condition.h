#pragma once

#include <memory>
#include <span>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"

namespace desmo {

/// Evaluator of the condition number of all equations of a model at a position: ‖A⁻¹‖∞ of
/// A = R⁻¹ Φ_φ S. S holds the nominal magnitudes of the unknowns: 1 for angles and directions, the
/// mechanism's size for points and distances. R holds the row sums of |Φ_φ S|, so that ‖A‖∞ = 1.
/// The number bounds, to first order, the relative change of position that a relative change of an
/// equation causes, whatever the units and the partition. The inverse is computed, not estimated:
/// n solves with sparse LU factors.
class ConditionNumber {
 public:
  /// Analyses the model, which must outlive this object.
  explicit ConditionNumber(const Model& model);
  explicit ConditionNumber(const Model&& model) = delete;
  ~ConditionNumber();

  /// Returns the condition number at positions q (coordinates): infinity if Φ_φ is singular in
  /// double precision or its inverse overflows, 1 if there are no unknowns.
  double operator()(std::span<const double> q);

 private:
  struct Matrix;
  std::unique_ptr<Matrix> matrix_;
};

/// Returns the order of magnitude of the relative errors that rounding causes: κ u in position, κ²
/// u in velocity, κ³ u in acceleration. Each level solves with Φ_φ once more, and amplifies the
/// error of the level before by κ.
/// - condition: κ
/// - u: unit roundoff of the scalar: 2⁻⁵³ for double, 2⁻²⁴ for float
inline PerLevel<double> accuracy_limit(double condition, double u) {
  return {condition * u, condition * condition * u, condition * condition * condition * u};
}

}  // namespace desmo
