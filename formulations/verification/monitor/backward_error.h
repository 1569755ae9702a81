#pragma once

#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/groupwise/jet.h"
#include "formulations/model/model.h"
#include "formulations/verification/monitor/scaled_system.h"

namespace desmo {

/// The residuals of the equations of an instant and of their time derivatives, whatever solved it,
/// at the cost of evaluating them once: a residual r leaves errors of up to ‖A⁻¹‖∞ ‖r‖∞. A rate
/// that was solved with a small pivot shows in it, and a row that was interpolated.
class BackwardError {
 public:
  /// levels: as far as each coordinate is solved. Both must outlive it.
  BackwardError(const Model& model, std::span<const Level> levels);

  /// Bounds of the errors that the residuals of each level cause at a condition number
  /// (verification/condition.h), relative to the scales; what errors of one level cause at the next
  /// is not in them. system: with the sums of rows somewhere near.
  PerLevel<double> operator()(const Instant& instant, const ScaledSystem& system,
                              const Scales& scales, double condition);

 private:
  const Model& model_;
  std::span<const Level> levels_;
  std::vector<Level> row_levels_;
  double size_;
  std::vector<Jet<double>> state_, phi_;
};

/// Returns, for each row, the lowest level to which one of its coordinates is solved.
std::vector<Level> levels_of_rows(const Model& model, std::span<const Level> levels);

}  // namespace desmo
