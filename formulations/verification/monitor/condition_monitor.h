#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Monitors the growth of the condition number since the last assessment where rates do not show
/// it: a motion that just misses a change point is smooth. It solves x = A⁻¹ b for four fixed b
/// without pattern, now and then (a *look*), with factors of its own. What it finds:
///
///   growth     of ‖x‖∞ of each group since the assessment
///   distance   of each irreducible block D to a singular one, d = 1/‖D⁻¹ b‖∞; it falls to zero
///   signs      of the determinants; one that has changed counts as infinite growth
///
/// The next look is due before any d can have halved. d has the slope of the last two looks, but
/// for its curvature, which is bounded: entries of D change by their own size when coordinates move
/// by their magnitudes. Between looks the growth counts as if d fell that fast.
class ConditionMonitor {
 public:
  /// system: the one of the model.
  ConditionMonitor(const Model& model, const ScaledSystem& system);

  /// Adds the way to an instant; instants come in order of time.
  void go_on(const Instant& instant);
  /// Returns whether the instant should be looked at.
  bool is_due() const { return used_ >= 1; }
  void look(const Instant& instant, ScaledSystem& system);
  /// Returns the way of any coordinate, in magnitudes, after which a block may be singular.
  double way_left() const;
  /// Returns the growth, at least 1, of the last look and what it may have become since; infinity
  /// where it was singular.
  double growth() const;
  /// Makes this instant the one to compare with. system: factorised at it.
  void reset(ScaledSystem& system);

 private:
  void take(ScaledSystem& system);
  void measure_distances(ScaledSystem& system);
  double until_halved(int block) const;
  double until_grown() const;
  void schedule();

  std::vector<double> state_;
  Eigen::ArrayXd unit_;                  // 1 / magnitude of each coordinate
  Eigen::ArrayXd last_;                  // q of the last instant
  Eigen::ArrayXd way_;                   // of each coordinate since the last look, in magnitudes
  Eigen::ArrayXd per_way_;               // 1 / way of each coordinate until the next look
  std::vector<std::vector<int>> reads_;  // coordinates that each group reads, its own included
  std::vector<GroupId> group_;           // group of each unknown
  std::vector<int> block_;               // irreducible block of each unknown
  std::vector<GroupId> of_block_;        // group of each block
  std::array<Eigen::ArrayXd, 4> right_;  // b
  Eigen::ArrayXd x_;                     // A⁻¹ b
  Eigen::ArrayXd now_, then_, before_;  // ‖x‖∞ of each group: last look, assessment, look before
  Eigen::ArrayXd distance_, distance_before_;  // d of each block: last look, look before
  std::vector<signed char> signs_;             // of the assessment
  Eigen::ArrayXd way_before_;                  // of what each group reads, between the last looks
  std::vector<double> per_way_of_group_;       // 1 / way until the next look
  double max_per_way_ = 0;                     // largest of per_way_
  double growth_ = 1;
  double used_ = 0;            // part of the way until the next look
  double all_way_before_ = 0;  // of any coordinate, between the last two looks
};

}  // namespace desmo
