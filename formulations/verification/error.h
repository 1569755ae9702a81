#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/formulation.h"
#include "formulations/planning/plan.h"
#include "formulations/scaling/scales.h"

namespace desmo {

/// Errors at one level, relative to Scales. Infinite where a number is none.
struct LevelError {
  double max = 0;     ///< over all outputs and instants
  double rms = 0;     ///< root of the mean square over all outputs and instants
  long compared = 0;  ///< outputs times instants; 0: max and rms say nothing
};

/// How wrong a solution is.
struct Error : PerLevel<LevelError> {
  int instants = 0;  ///< compared
};

/// Gathers max and rms of errors at one level.
class ErrorSum {
 public:
  void add(double error);  ///< not NaN (see relative())
  LevelError result() const;

 private:
  double max_ = 0, squares_ = 0;
  long compared_ = 0;
};

/// Compares the instants that it is handed with a reference, where the reference has them, in
/// outputs that all formulations share: the points, directions, angles and distances of the
/// mechanism, driven ones included, fixed ones left out. The error of an output is the Euclidean
/// norm of the difference, by its scale; angles differ by whole turns if they do. It is exact where
/// the reference has rests: an error of 1e-20 shows as that.
///
/// An observer: hand it to Formulation::run, instants in order of time. Instants that the
/// reference has not are skipped at the cost of a comparison; nothing is taken from the heap.
class ErrorMeasure final : public Observer {
 public:
  /// All outputs at all levels. The reference must outlive the measure.
  ErrorMeasure(const Model& model, std::span<const ReferenceInstant> reference,
               const Scales& scales);
  /// Of these outputs only, each as far as it is asked for (Plan::outputs); fixed ones are skipped.
  ErrorMeasure(const Model& model, std::span<const ReferenceInstant> reference,
               const Scales& scales, std::span<const Asked> outputs);

  Flow observe(const Instant& instant) noexcept override;
  /// Of what was accepted so far. An error exists only where instants were compared: see
  /// Error::instants, which is the size of the reference after a complete run.
  Error error() const;

 private:
  struct Output {
    int first, size;  // coordinates
    Level level;
    PerLevel<double> scale;
  };
  void compare(Level level, std::span<const double> found, std::span<const double> reference,
               std::span<const double> rest);

  std::span<const ReferenceInstant> reference_;
  std::vector<Output> outputs_;
  int instants_ = 0;
  std::size_t next_ = 0;  // in the reference
  PerLevel<ErrorSum> sums_;
};

}  // namespace desmo
