#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/error.h"

namespace desmo {

/// Observer that measures how far a solution violates the equations, as opposed to its error. It
/// evaluates Φ and its time derivatives Φ_q q̇ and Φ_q q̈ + Φ̇_q q̇ in quadruple precision, from
/// the residuals alone. Each equation is divided by the magnitude of its terms, Σ |∂Φ/∂qᵢ| sᵢ at
/// the instant's position. sᵢ is the scale of coordinate i at that level.
///
/// Hand it to Formulation::run. Instants whose time is not in `times` are skipped. No heap memory
/// is allocated; an instant costs a few microseconds a coordinate.
class ViolationMeasure final : public Observer {
 public:
  /// times: ascending, not empty [s]. The times and the model must outlive the measure.
  ViolationMeasure(const Model& model, const Scales& scales, std::span<const double> times);
  ~ViolationMeasure() override;

  Flow observe(const Instant& instant) noexcept override;
  /// Returns maximum and root mean square over all equations of the instants observed so far.
  /// Levels that the run did not deliver have nothing compared.
  SolutionError violation() const;

 private:
  struct WideEquations;  // in quadruple precision
  std::unique_ptr<WideEquations> equations_;
  std::span<const double> times_;
  std::size_t next_ = 0;  // index of the next time in times_
  int instants_ = 0;
  PerLevel<std::vector<double>> coordinate_scales_, row_scales_;
  PerLevel<ErrorSum> sums_;
};

}  // namespace desmo
