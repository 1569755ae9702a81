#pragma once

#include "formulations/scaling/scales.h"
#include "formulations/verification/monitor/assessment.h"

namespace desmo {

/// What an assessment would say of an instant that is not assessed, from the residual at which its
/// position was accepted and from the growth of the condition number since the last that was:
///
///   position       what rounding makes of it, and κ × slope × residual, as they were in the last
///                  that showed them
///   rates          those of the last, as the position, and κ² and κ⁴ times as the growth: as a
///                  level divides by Φ_φ, and as much again for equations that it is solved less
///                  well from
class Expectation {
 public:
  /// Learns from an assessment. growth: what was known of it before.
  void learn(const Assessment& assessment, double growth, double residual);
  /// The scales that rates are relative to have grown.
  void rescale(const Scales& from, const Scales& to);

  /// Without a margin.
  Assessment operator()(double growth, double residual) const;
  /// With one: ten times, or twice as far as expectations have been off.
  Assessment with_margin(Assessment expected) const;
  /// Whether residuals so large have not been assessed yet.
  bool is_new(double residual) const;

 private:
  Assessment last_{};
  double max_residual_ = 0;
  double slope_ = 0;  // of position over the residual and the condition number
  PerLevel<double> margin_;
};

}  // namespace desmo
