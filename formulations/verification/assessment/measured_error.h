#pragma once

#include <memory>
#include <span>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/assessment.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Measured errors of a solved instant, where the Assessor's bounds are too wide: these hold for
/// any signs of all roundings. The instant is refined in `long double` with factors in double
/// precision; what it was off by is its error, but for the rounding of the longer numbers. Where
/// this rounding alone exceeds a limit, 113 bits decide.
class MeasuredError {
 public:
  /// levels, asked: the levels up to which each coordinate is solved, and is an output. All must
  /// outlive this object.
  MeasuredError(const Model& model, ScaledSystem& system, std::span<const Level> levels,
                std::span<const Level> asked);
  ~MeasuredError();

  /// Returns the errors with a margin, as bounds of an Assessment; infinity where the refinement
  /// does not converge fast, 0 at levels that the instant does not have. Overwrites the system's
  /// factors. Allocates in KLU, and where 113 bits decide for the first time.
  /// - a: the instant's assessment, relative to these scales
  /// - limit: what the errors are compared with
  PerLevel<double> operator()(const Instant& instant, const Scales& scales, const Assessment& a,
                              const PerLevel<double>& limit);

 private:
  template <class Wide>
  class Refinement;
  struct Refinements;
  std::unique_ptr<Refinements> refinements_;
};

}  // namespace desmo
