#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/assessment.h"
#include "formulations/verification/assessment/enclosed_motion.h"
#include "formulations/verification/assessment/inverse_norm.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Estimator of the errors of solved instants, from their residuals and all equations at once,
/// whatever solved them. A = R⁻¹ Φ_φ S, S being the characteristic lengths of the unknowns and R
/// the row sums (ScaledSystem). Its bounds:
///
///   position      δ = |A⁻¹ R⁻¹ Φ| + |A⁻¹| R⁻¹ (rounding of Φ and of the drivers)
///   existence     η = max |A⁻¹| R⁻¹ |change of Φ_φ within 2 δ| S δ / δ; singular unless η < ½
///   velocity      |Φ_φ⁻¹ Φ̇| + |Φ_φ⁻¹| (uncertainty of Φ̇ within the bounds of position)
///   acceleration  likewise with Φ̈, within the bounds of position and velocity
///
/// Each bound is divided by 1 − η. It then holds with Φ_φ⁻¹ of any position within the bounds
/// (Newton–Kantorovich). η is measured in units of each group's own error δ: the uncertain end of a
/// long chain does not make its beginning uncertain. Φ, Φ̇, Φ̈ and their uncertainties are evaluated
/// in jets (groupwise/jet.h) of numbers with bounds (rounded.h). |A⁻¹| is estimated
/// (inverse_norm.h), and multiplied by three for what the estimate may miss.
class Assessor {
 public:
  /// levels: the level up to which each coordinate is solved (Plan::levels); empty: as far as the
  /// instant. asked: the level up to which it is an output; empty: as far as solved. norm: in which
  /// unknowns are compared; tests leave out that of the blocks. The model must outlive the
  /// assessor.
  explicit Assessor(const Model& model, std::span<const Level> levels = {},
                    std::span<const Level> asked = {}, Norm norm = Norm::of_blocks);
  Assessor(const Assessor&) = delete;
  Assessor& operator=(const Assessor&) = delete;

  /// Returns the assessment of an instant. scales: scales of the rates, of the motion or of this
  /// instant. Only KLU allocates.
  Assessment operator()(const Instant& instant, const Scales& scales);

  /// Returns the cause that limits the accuracy of the instant assessed last.
  Limit limit(const Instant& instant, const Scales& scales, const Assessment& assessment);

  /// Returns an instant corrected by Newton steps with factors at its own position, as long as the
  /// steps halve: as accurate as conditioning allows. Its numbers are valid until the next call.
  Instant corrected(const Instant& instant);
  /// Returns the last of these steps, in magnitudes; infinity where there was none.
  double last_correction() const { return last_correction_; }

  /// Returns the equations, factorised at the position used last.
  ScaledSystem& system() { return system_; }
  /// Returns the magnitude of each row (Magnitudes), whatever the position.
  const Eigen::ArrayXd& row_magnitudes() const { return row_magnitudes_; }
  std::span<const Level> levels() const { return levels_; }

 private:
  struct Bound {
    double whole, rounding;
  };
  void equations_of(Level level);
  Bound of_outputs(Level level, const Scales& scales);
  double of_residuals();
  void enclose(Level level);
  void at_least(const Eigen::Ref<const Eigen::ArrayXd>& errors);
  double of_group(int unknown) const;
  const Eigen::ArrayXd& inverse(const Eigen::ArrayXd& errors);
  double contraction();
  void widen(Level level, double times);
  double correct(Level level, std::vector<double>& values);

  const Model& model_;
  std::vector<Level> levels_, asked_, row_levels_;
  ScaledSystem system_;
  EnclosedMotion motion_;
  InverseNorm of_system_, of_change_;  // one each, since the worst unknown is remembered
  InverseNorm of_residuals_;
  PerLevel<InverseNorm> to_outputs_, to_errors_;
  Eigen::ArrayXd weights_, off_, unknown_, change_;
  Eigen::ArrayX2d signs_, probes_;  // signs_: without a pattern
  Eigen::ArrayXd row_;              // of the inverse
  Eigen::ArrayXd row_magnitudes_;   // of the equations, as in their residuals
  Eigen::ArrayXd error_;  // error bound of each unknown in its magnitude, equal within a group
  std::vector<GroupId> group_;      // group of each unknown
  std::vector<double> max_;         // error bound of each group
  std::vector<double> max_length_;  // the same in lengths
  std::vector<double> state_;
  std::vector<Rounded> phi_;
  std::vector<Jet<Rounded>> phi_motion_;
  PerLevel<std::vector<double>> corrected_;
  double last_correction_ = INFINITY;
};

}  // namespace desmo
