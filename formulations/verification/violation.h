#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/error.h"

namespace desmo {

/// How far a solution is from satisfying the equations, which is not how wrong it is: Φ, its time
/// derivative Φ_q q̇ and its second, Φ_q q̈ + Φ̇_q q̇, evaluated in quadruple precision from the
/// residuals alone. Each equation is relative to the magnitude of its terms, Σ |∂Φ/∂q_i| s_i at the
/// position at hand, where s_i is the scale of coordinate i at that level: numbers without unit.
///
/// An observer: hand it to Formulation::run. Instants before the first and after the last of
/// `times`, and those between that are not in it, are skipped; nothing is taken from the heap. An
/// instant costs a few microseconds a coordinate.
class ViolationMeasure final : public Observer {
 public:
  /// times: ascending, not empty; they must outlive the measure, and so must the mechanism.
  ViolationMeasure(const Model& model, const Scales& scales, std::span<const double> times);
  ~ViolationMeasure() override;

  Flow observe(const Instant& instant) noexcept override;
  /// Maximum and rms over all equations and instants accepted so far. What was not requested of
  /// the run has nothing compared.
  Error violation() const;

 private:
  struct Equations;  // in quadruple precision
  std::unique_ptr<Equations> equations_;
  std::span<const double> times_;
  std::size_t next_ = 0;  // in times_
  int instants_ = 0;
  PerLevel<std::vector<double>> coordinate_scales_, row_scales_;
  PerLevel<ErrorSum> sums_;
};

}  // namespace desmo
