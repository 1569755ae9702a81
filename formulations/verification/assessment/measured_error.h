#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/groupwise/jet.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Measured errors of a solved instant, where the Assessor's bounds are too wide: these hold for
/// any signs of all roundings. The instant is refined in `long double` with factors in double
/// precision; what it was off by is its error, but for the rounding of the longer numbers.
class MeasuredError {
 public:
  /// levels, asked: the levels up to which each coordinate is solved, and is an output. All must
  /// outlive this object.
  MeasuredError(const Model& model, ScaledSystem& system, std::span<const Level> levels,
                std::span<const Level> asked);

  /// Returns the errors with a margin, as bounds of an Assessment; infinity where the refinement
  /// does not converge fast, 0 at levels that the instant does not have. condition: of the
  /// instant's assessment. Overwrites the system's factors. Allocates only in KLU.
  PerLevel<double> operator()(const Instant& instant, const Scales& scales, double condition);

 private:
  using Wide = long double;
  void take(const Instant& instant);
  double refine(Level level);
  double error(const Instant& instant, Level level, const Scales& scales) const;

  const Model& model_;
  ScaledSystem& system_;
  std::span<const Level> levels_, asked_;
  std::vector<Level> row_levels_;
  std::vector<Jet<Wide>> state_, phi_;
  std::vector<double> position_;  // state at which the system is factorised
  Eigen::ArrayXd off_;
};

}  // namespace desmo
