#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/accuracy/scales.h"
#include "formulations/formulation.h"
#include "formulations/safety/assessment.h"
#include "formulations/safety/enclosed_motion.h"
#include "formulations/safety/inverse_norm.h"
#include "formulations/safety/scaled_system.h"

namespace desmo {

/// Assesses solved instants of a mechanism a posteriori, all equations at once, whatever solved
/// them. With A = R⁻¹ Φ_φ S, S the natural magnitudes of the unknowns and R the row sums:
///
///   position       δ = max |A⁻¹| R⁻¹ (|Φ| + rounding of Φ and of the drivers)
///   there is one   η = ‖A⁻¹‖ max R⁻¹ |change of Φ_φ within 2 δ| S 1 < ½; else it is singular
///   velocity       max |Φ_φ⁻¹| |Φ_q q̇|, and
///   acceleration   max |Φ_φ⁻¹| |Φ_q q̈ + Φ̇_q q̇|, of all positions and velocities within their
///                  bounds
///
/// each over 1 − η: the errors, for Φ_φ⁻¹ at any position in question (Newton–Kantorovich). What is
/// in | | comes from the residuals alone, in jets (accuracy/jet.h) of numbers that carry bounds
/// (rounded.h); the maxima are estimated (inverse_norm.h).
class Assessor {
 public:
  /// levels: as far as each coordinate is solved (Plan::levels); none: as far as the instant. The
  /// mechanism must outlive the assessor.
  explicit Assessor(const Mechanism& mechanism, std::span<const Level> levels = {});
  Assessor(const Assessor&) = delete;
  Assessor& operator=(const Assessor&) = delete;

  /// scales: what rates are relative to, of the motion or of this instant. Nothing is taken from
  /// the heap but by KLU.
  Assessment operator()(const Instant& instant, const Scales& scales);

  /// An instant with the corrections that factors at its own position make, and then another, as
  /// long as they shrink: as right as the conditioning allows. Its numbers are valid until the
  /// next.
  Instant corrected(const Instant& instant);

  /// At the position of the last assessment.
  ScaledSystem& system() { return system_; }
  std::span<const Level> levels() const { return levels_; }

 private:
  double outputs(Level level, const Scales& scales);
  double contraction(double condition);
  double rates(Level level, const Scales& scales);
  double correct(Level level, std::vector<double>& values);

  const Mechanism& mechanism_;
  std::vector<Level> levels_, row_levels_;
  ScaledSystem system_;
  EnclosedMotion motion_;
  InverseNorm norm_;
  Eigen::ArrayXd weights_, right_, change_;
  std::vector<double> state_;
  std::vector<Rounded> phi_;
  std::vector<Jet<Rounded>> phi_motion_;
  PerLevel<std::vector<double>> corrected_;
};

}  // namespace desmo
