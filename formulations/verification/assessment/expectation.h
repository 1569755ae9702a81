#pragma once

#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/assessment.h"

namespace desmo {

/// Prediction of the assessment of an instant that is not assessed. It uses the residual at which
/// the position was accepted, and the growth g of the condition number κ since the last assessment:
///
///   position       g × rounding + g κ × slope × residual, where slope is
///                  (bound − rounding) / (κ × residual) of the last assessment that showed it
///   velocity       last bound × growth of the position bound × g²
///   acceleration   last bound × growth of the position bound × g⁴
///
/// Every level divides by Φ_φ, and again for the errors of the levels that it is solved from.
class Expectation {
 public:
  /// Learns from an assessment. growth, residual: the instant's signals before it was assessed.
  void learn(const Assessment& assessment, double growth, double residual);
  /// Converts the last bounds to grown scales of rates.
  void rescale(const Scales& from, const Scales& to);

  /// Returns the predicted assessment, without a safety margin.
  Assessment operator()(double growth, double residual) const;
  /// Returns the bounds times a margin: ten, or twice the largest ratio by which predictions were
  /// low.
  Assessment with_margin(Assessment expected) const;
  /// Returns whether a residual exceeds all assessed ones by more than a factor of four.
  bool is_new(double residual) const;

 private:
  Assessment last_{};
  double max_residual_ = 0;
  double slope_ = 0;  // (bound.position − rounding) over condition × residual
  PerLevel<double> margin_;
};

}  // namespace desmo
