#pragma once

#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/groupwise/jet.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Residuals of an instant's equations and of their time derivatives, whatever solved it, for the
/// price of one evaluation. A residual r allows errors of up to ‖A⁻¹‖∞ ‖r‖∞. Residuals reveal rates
/// solved with small pivots and inaccurate interpolated instants.
class BackwardError {
 public:
  /// levels: the level up to which each coordinate is solved. All must outlive this object.
  BackwardError(const Model& model, const WholeSystem& equations, std::span<const Level> levels);

  /// Returns bounds of the errors that the residuals of each level cause, relative to the scales.
  /// Errors that one level passes on to the next are not included.
  /// - condition: the condition number (verification/condition.h)
  PerLevel<double> operator()(const Instant& instant, const Scales& scales, double condition);

  /// Takes the row sums of a system that is factorised at a position of the motion: residuals are
  /// compared with them. They are not those of the last factorisation, whose position a failed step
  /// may have made up.
  void take_row_sums(const ScaledSystem& system);

 private:
  const Model& model_;
  std::span<const Level> levels_;
  std::vector<Level> row_levels_;
  const WholeSystem& equations_;
  double size_;
  Eigen::ArrayXd sums_;  // in magnitudes of the whole mechanism
  std::vector<Jet<double>> state_, phi_;
};

/// Returns, for each row, the lowest level to which one of its coordinates is solved.
std::vector<Level> levels_of_rows(const Model& model, std::span<const Level> levels);

}  // namespace desmo
