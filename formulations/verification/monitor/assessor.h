#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/monitor/assessment.h"
#include "formulations/verification/monitor/enclosed_motion.h"
#include "formulations/verification/monitor/inverse_norm.h"
#include "formulations/verification/monitor/scaled_system.h"

namespace desmo {

/// Assesses solved instants of a mechanism a posteriori, all equations at once, whatever solved
/// them. With A = R⁻¹ Φ_φ S, S the natural magnitudes of the unknowns and R the row sums:
///
///   position       δ = |A⁻¹ R⁻¹ Φ| + |A⁻¹| R⁻¹ (rounding of Φ and of the drivers)
///   there is one   η = max |A⁻¹| R⁻¹ |change of Φ_φ within 2 δ| S δ / δ < ½; else it is singular
///   velocity       |Φ_φ⁻¹ Φ̇| + |Φ_φ⁻¹| (what Φ̇ may be more or less), and
///   acceleration   likewise of Φ̈, at all positions and velocities within their bounds
///
/// each over 1 − η: the errors, for Φ_φ⁻¹ at any position in question (Newton–Kantorovich, in the
/// norm in which the errors δ of all groups are equal, so that a long chain whose end is uncertain
/// does not make its beginning so). What is known of Φ and how much more or less it may be comes
/// from the residuals alone, in jets (groupwise/jet.h) of numbers that carry bounds (rounded.h);
/// what |A⁻¹| makes of it at most is estimated (inverse_norm.h), and taken three times, for what
/// the estimate may miss.
class Assessor {
 public:
  /// levels: as far as each coordinate is solved (Plan::levels); none: as far as the instant. The
  /// mechanism must outlive the assessor.
  explicit Assessor(const Model& model, std::span<const Level> levels = {});
  Assessor(const Assessor&) = delete;
  Assessor& operator=(const Assessor&) = delete;

  /// scales: what rates are relative to, of the motion or of this instant. Nothing is taken from
  /// the heap but by KLU.
  Assessment operator()(const Instant& instant, const Scales& scales);

  /// Returns which of these bounds limits the instant assessed last.
  Limit limit(const Instant& instant, const Scales& scales, const Assessment& assessment);

  /// An instant with the corrections that factors at its own position make, and then another, as
  /// long as they shrink: as right as the conditioning allows. Its numbers are valid until the
  /// next.
  Instant corrected(const Instant& instant);

  /// At the position of the last assessment.
  ScaledSystem& system() { return system_; }
  std::span<const Level> levels() const { return levels_; }

 private:
  struct Bound {
    double whole, rounding;
  };
  void equations_of(Level level);
  Bound of_outputs(Level level, const Scales& scales);
  void enclose(Level level);
  void at_least(const Eigen::ArrayXd& errors);
  const Eigen::ArrayXd& inverse(const Eigen::ArrayXd& errors);
  double contraction();
  void widen(Level level, double times);
  double correct(Level level, std::vector<double>& values);

  const Model& model_;
  std::vector<Level> levels_, row_levels_;
  ScaledSystem system_;
  EnclosedMotion motion_;
  InverseNorm of_system_, of_change_;  // each is asked the same again and again
  PerLevel<InverseNorm> to_outputs_, to_errors_;
  Eigen::ArrayXd weights_, off_, unknown_, change_;
  Eigen::ArrayXd error_;        // of each unknown at most, in its magnitude, as large in a group
  std::vector<GroupId> group_;  // of each unknown
  std::vector<double> max_;     // error of each group
  std::vector<double> state_;
  std::vector<Rounded> phi_;
  std::vector<Jet<Rounded>> phi_motion_;
  PerLevel<std::vector<double>> corrected_;
};

}  // namespace desmo
