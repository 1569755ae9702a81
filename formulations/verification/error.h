#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/formulation.h"
#include "formulations/model/plan.h"
#include "formulations/model/scales.h"

namespace desmo {

/// Errors at one level, relative to Scales; infinite if a solved number is NaN.
struct LevelError {
  double max = 0;     ///< maximum over all outputs and instants
  double rms = 0;     ///< root mean square over all outputs and instants
  long compared = 0;  ///< outputs times instants compared; 0: max and rms say nothing
};

/// Errors of a solution at each level.
struct SolutionError : PerLevel<LevelError> {
  int instants = 0;  ///< instants compared
};

/// Observer that compares the instants of a run (Formulation::run) with a reference. It skips
/// instants at times that the reference does not have. observe() allocates nothing.
///
/// Outputs are the points, directions, angles and distances of the model. Driven outputs are
/// included, fixed ones are not. The error of an output is the Euclidean norm of its difference
/// from the reference, divided by its scale (Scales). Angles are compared as they are, so a whole
/// turn counts as an error. Differences include the remainders of the reference, if it has any: an
/// error of 1e-20 then shows as 1e-20.
class ErrorMeasure final : public Observer {
 public:
  /// outputs: entities to compare, each up to its level (Plan::outputs); fixed ones are skipped.
  /// Empty: all entities at all levels. The reference must outlive the measure.
  ErrorMeasure(const Model& model, std::span<const ReferenceInstant> reference,
               const Scales& scales, std::span<const Output> outputs = {});
  ErrorMeasure(const Model& model, const std::vector<ReferenceInstant>&& reference,
               const Scales& scales, std::span<const Output> outputs = {}) = delete;

  Flow observe(const Instant& instant) noexcept override;
  /// Returns the errors of the instants observed so far. SolutionError::instants counts those that
  /// were compared: the size of the reference if the run had all of its times.
  SolutionError error() const;

 private:
  struct Compared {
    int first, size;  // coordinates
    Level level;
    PerLevel<double> scale;
  };
  void compare(Level level, std::span<const double> found, std::span<const double> reference,
               std::span<const double> remainder);

  std::span<const ReferenceInstant> reference_;
  std::vector<Compared> compared_;
  std::size_t next_ = 0;  // index of the next reference instant
  SolutionError so_far_;  // LevelError::rms holds the sum of squares
};

}  // namespace desmo
