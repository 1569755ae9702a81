#pragma once

#include <functional>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"
#include "formulations/motion/groupwise/dense_lu.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/reference/global_solver.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo {

/// Drivers' values and derivatives at a parameter, in the model's order.
using DriverPath = std::function<std::vector<MotionSample<Quadruple>>(const Quadruple&)>;

/// Returns the motions of a model's drivers; the parameter is time [s].
DriverPath motions_of(const Model& model);

/// Returns the path of drivers that go straight: their values at a parameter s are from + s · rate.
DriverPath straight_path(std::vector<Quadruple> from, std::vector<Quadruple> rate);

/// Follows the smooth continuation of a position in quadruple precision. A step is accepted if
/// - Newton's method contracts from the Taylor prediction at once,
/// - the rates at both ends lead from one end to the other,
/// - the determinants of irreducible blocks keep their signs and, within a factor of five, their
///   magnitudes, and go on falling where they fell: else one may touch zero on the way;
///   steps below `crossing_step` may pass a singular position.
/// Other steps are halved. So a fold that is 1e-24 from the path is resolved.
class Continuation {
 public:
  static constexpr double crossing_step = 1e-12, min_step = 1e-24;
  static constexpr int max_tries = 1000;  // steps tried by one call of go_to(), ≤

  /// Assembles at the model's estimate, drivers included. Throws std::runtime_error when Newton's
  /// method does not converge there.
  explicit Continuation(const Model& model);

  /// Begins another path from the present position, which has to belong to `parameter`.
  void begin(DriverPath path, const Quadruple& parameter);

  /// Follows the path to a parameter. Returns false where no step leads on; the position is then
  /// the last one whose rates have digits, from which the path may lead past a singular position.
  bool go_to(const Quadruple& parameter);

  const Quadruple& parameter() const { return now_.parameter; }
  /// Returns q, q̇ and q̈ at the present parameter.
  WideInstant instant() const;
  /// Return the condition number at the present position, and the largest since the last call.
  double condition();
  double max_condition();
  /// Return how many steps have passed a singular position, and where the last of them ended.
  int crossings() const { return crossings_; }
  const Quadruple& crossed_at() const { return crossed_at_; }

 private:
  using Determinants = std::vector<DenseLu<Quadruple>::Determinant>;
  Determinants determinants() const;
  bool try_step(const Quadruple& next);
  double rounding() const;
  bool is_continuous(const Quadruple& step) const;

  const Model& m_;
  std::vector<double> magnitude_;
  double far_ = 1;  // largest coordinate, in magnitudes: rounding grows with it
  GlobalSolver<Quadruple> solver_;
  ConditionNumber condition_number_;
  DriverPath path_;
  Quadruple step_ = 0, crossed_at_ = 0;
  struct Place {
    Quadruple parameter;
    ScalarState<Quadruple> state;
    Determinants determinants;  // of the blocks
    double condition;
  };
  Place now_;      // the end of the last accepted step
  Place regular_;  // the last place of a condition number below `passed`
  std::vector<PartDefinition> blocks_;
  std::vector<double> slopes_;  // slopes of the determinants' logarithms in the last accepted step
  double max_condition_ = 0;
  int crossings_ = 0;
};

}  // namespace desmo
