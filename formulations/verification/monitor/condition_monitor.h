#pragma once

#include <Eigen/Core>
#include <cmath>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Monitors the growth of the condition number since the last assessment where rates do not show
/// it: a motion that just misses a change point is smooth. It solves x = (M⁻¹ Φ_φ S)⁻¹ b for four
/// fixed b without pattern, now and then (a *look*), with factors of its own. M holds the
/// magnitudes of the equations: where two points all but meet, the whole row of their distance
/// vanishes, which A does not show. What it finds:
///
///   growth     of ‖x‖∞ of each group since the assessment
///   distance   of each irreducible block D to a singular one, d = 1/‖D⁻¹ b‖∞; it falls to zero
///   signs      of the determinants; one that has changed counts as infinite growth
///
/// Each look holds for the positions around it in which no d can have halved. d has the slope
/// between the last two looks, whether it fell or rose, but for its curvature, which is bounded:
/// entries of D change by their own size when coordinates move by their magnitudes. The next look
/// is due where neither the last one nor an earlier one holds, so a motion that returns is not
/// looked at again. Away from a look the growth counts as if d had halved.
///
/// Coordinates are compared with the look's only now and then. In between, their rates bound how
/// far they have gone.
class ConditionMonitor {
 public:
  /// system: the one of the model. row_magnitudes: M, (rows).
  ConditionMonitor(const Model& model, const ScaledSystem& system,
                   const Eigen::ArrayXd& row_magnitudes);

  /// Moves on to an instant. ways: how far drivers and unknowns have moved at most in the step to
  /// it, the first in magnitudes, the second by the weights of reset(). Infinity: not known.
  struct Ways {
    double drivers = INFINITY, unknowns = INFINITY;
  };
  void go_on(const Instant& instant, const Ways& ways);
  /// Returns whether the instant should be looked at.
  bool is_due() const { return used_ >= 1; }
  void look(const Instant& instant, ScaledSystem& system);
  /// Returns how far any coordinate may move, in magnitudes, before a block may become singular.
  double way_left() const;
  /// Returns the growth at the present instant, at least 1: that of the look that holds, times what
  /// may have come since. Infinity: the look was singular.
  double growth() const;
  /// Makes this instant the one to compare with. system: factorised at it. weights: of unknowns
  /// (SensitivityMonitor::weights()), which stay where they are.
  void reset(const Instant& instant, ScaledSystem& system, const Eigen::ArrayXd& weights);

 private:
  struct Look {
    Eigen::Map<Eigen::ArrayXd> q;
    Eigen::Map<Eigen::ArrayXd> per_way;   // 1 / change of each coordinate up to which it holds
    Eigen::Map<Eigen::ArrayXd> share;     // ‖x‖∞ of each group
    Eigen::Map<Eigen::ArrayXd> distance;  // d of each block
    std::span<signed char> signs;
    double max_per_way = 0;     // the largest of per_way, by magnitudes
    Eigen::Index decisive = 0;  // the first of those that ruled it out last
  };
  static double used(const Look& look, std::span<const double> q);
  bool turn_to(Look& look, std::span<const double> q) const;
  void take(const Instant& instant, ScaledSystem& system);
  void make_looks();
  Look& add(const Instant& instant);
  void measure(Look& look, ScaledSystem& system);
  void schedule(Look& look);
  static double until_halved(double distance, double slope);
  double until_grown(const Look& look, double way) const;
  void compare();
  void weigh_ways();

  std::vector<double> state_;
  Eigen::ArrayXd unit_;                  // 1 / magnitude of each coordinate
  std::vector<int> angles_;              // coordinates
  std::vector<std::vector<int>> reads_;  // coordinates that each group reads, its own included
  std::vector<GroupId> group_;           // group of each unknown
  std::vector<int> block_;               // irreducible block of each unknown
  std::vector<GroupId> of_block_;        // group of each block
  Eigen::ArrayX4d right_;                // b
  Eigen::ArrayX4d x_;                    // what b becomes
  const Eigen::ArrayXd row_magnitudes_;  // M
  Eigen::ArrayXd way_;                   // of each coordinate since the look before, in magnitudes
  Eigen::ArrayXd share_before_, distance_before_;  // of that look
  std::vector<double> way_of_group_;               // the largest of what each group reads
  std::vector<double> per_way_of_group_;
  Eigen::ArrayXXd numbers_;  // of looks, in columns
  std::vector<signed char> signs_of_looks_;
  std::vector<Look> looks_;  // in turn; the oldest is replaced
  int count_ = 0, newest_ = -1, current_ = 0;
  Eigen::ArrayXd then_;                // shares at the assessment
  std::vector<signed char> signs_;     // of the assessment
  double growth_ = 1;                  // of the current look
  Eigen::ArrayXd drivers_, unknowns_;  // magnitude, 1 / weight of these coordinates, else 0
  double used_per_drivers_ = 0, used_per_unknowns_ = 0;  // of the way on which the look holds
  double used_ = 0;     // part of the way on which it holds, at most
  int unmeasured_ = 0;  // instants since coordinates were compared
};

}  // namespace desmo
