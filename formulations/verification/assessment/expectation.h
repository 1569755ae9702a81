#pragma once

#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/assessment.h"

namespace desmo {

/// Bounds of an instant that is not assessed. They use the residual at which the position was
/// accepted, and what has grown since the last assessment: the condition number by g, q̇ over the
/// drivers' rates by s ≤ g, and these:
///
///   position       10 g × rounding + 2 g × per_residual × residual
///   velocity       10 × last bound × growth of the position bound × g s × growth of the drivers
///   acceleration   10 × last bound × growth of the position bound × g² s² × growth of the drivers
///
/// Every level divides by Φ_φ, and again for the errors of the levels that it is solved from. Φ̇ has
/// q̇ as a factor; Φ̈ has q̇² and q̈, which grows by g s² at most. The margin of ten, or twice the
/// largest ratio by which the bounds were low, is for what neither signal shows.
class Expectation {
 public:
  /// Signals of an instant: what has grown since the last assessment, and the residual.
  struct Signals {
    double growth = 1;                  ///< of the condition number, at least that of the rates
    double rates = 1;                   ///< growth of q̇ over the drivers' rates
    PerLevel<double> drivers{1, 1, 1};  ///< growth of the drivers' motion
    double residual = 0;
  };

  /// Learns from an assessment. signals: of the instant before it was assessed.
  void learn(const Assessment& assessment, const Signals& signals);
  /// Converts the last bounds to grown scales of rates.
  void rescale(const Scales& from, const Scales& to);

  /// Returns what may be stated.
  Assessment operator()(const Signals& signals) const;

 private:
  Assessment without_margin(const Signals& signals) const;

  Assessment last_{};
  PerLevel<double> margin_;
};

}  // namespace desmo
