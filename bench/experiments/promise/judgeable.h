// What the truth of a scene allows to be judged.
#pragma once

#include "bench/experiments/promise/drawn_scene.h"
#include "formulations/base/per_level.h"

namespace desmo::promise {

/// The numbers that decide verdicts.
struct VerdictLimits {
  /// κ below which a flag has no cause: rounding by 1e-16 leaves ten digits there.
  static constexpr double well_conditioned = 1e6;
  /// A bound of half a scale says that no digit is known; an error cannot contradict it.
  static constexpr double no_digit = 0.5;
  /// Least scale of accelerations over that of speeds, as in monitors (RunningScales).
  static constexpr double min_scale = 0.01;
  /// Error over its bound that is accepted: the run's scales are not exactly those of the truth.
  static constexpr double scale_slack = 1.01;
  /// κ from which rounding decides between two motions: ten times 1/√u, in double precision and in
  /// single. What is nearer the limit is judged.
  static constexpr double undecided = 1e9, undecided_single = 4e4;
  /// Ratio of κ between two instants to κ at them from which two paths meet between them only.
  static constexpr double nearer_between = 100;
};

/// Solves instants of an overconstrained mechanism again, with other equations where these are
/// better. Both answers are right: rounding of the mechanism's numbers decides between them. An
/// instant has no answer where an equation left out does not hold.
void add_other_answers(DrawnScene& scene);

/// Returns whether the mechanism has a position at this instant.
bool has_answer(const TrueInstant& truth);

/// Returns the error that the truth itself may have: quadruple precision, near a singular position.
PerLevel<double> floor_of(const TrueInstant& truth);

/// Returns whether the true motion is well-conditioned from one instant to another, on the way too.
bool is_regular(const DrawnScene& scene, int from, int to);

/// Returns the first instant from which on rounding decides which of two motions is followed. Two
/// paths that come within √u of each other change places if numbers are rounded by u. The condition
/// number is 1/√u there.
/// - double precision: the scene's own numbers are rounded. Only paths that meet between two
///   instants count: where they meet at an instant, the run has to flag it.
/// - single precision: the run cannot tell such paths apart, wherever they meet.
int decided_until(const DrawnScene& scene, bool is_single);

}  // namespace desmo::promise
