#pragma once

#include <span>
#include <vector>

#include "cases/generators/dyad_chain.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo::extremes {

/// The motion of a chain of dyads (DyadChain) in quadruple precision. Each dyad's joint is an
/// intersection of two circles, a closed form. Only the crank's motion is computed by code that
/// formulations use, too.
class ChainSolution {
 public:
  /// model: of a mechanism that consists of the chain alone. Both must outlive the solution.
  ChainSolution(const DyadChain& chain, const Model& model);

  /// Sets the branch of each dyad from positions q: whether its joint is left or right of the line
  /// from the joint before to the pivot. Rocker angles are unwrapped from their values in q on. The
  /// constructor calls it with the model's estimate.
  void declare(std::span<const double> q);

  /// Solves at time t [s]. Returns false where there is no answer: the crank's motion is not finite
  /// in double precision, or a dyad cannot be closed. Nor is there one where a dyad is stretched or
  /// folded: its rates are not determined.
  bool solve(double t);

  /// Returns the instant solved last.
  ReferenceInstant instant() const { return rounded(now_); }

  /// Returns the sensitivity of the instant solved last to rounding: the largest change of a
  /// joint's position, to first order, when every length and every joint before it is rounded to
  /// double. It is divided by the unit roundoff and by the nominal size.
  double condition() const { return condition_; }

 private:
  struct Joint {
    Quadruple x, y, vx, vy, ax, ay;
  };
  struct Place {
    int joint, angle;   // indices in q of the joint's x and of the rocker's angle
    int side;           // the joint is left (1) or right (-1) of the line that declare() names
    double last_angle;  // rocker's angle, unwrapped, at the instant solved last [rad]
  };

  /// Solves a dyad whose coupler begins at joint `from`. Returns whether it can be closed.
  bool close(std::size_t dyad, const Joint& from, Joint& to);
  void put(int coordinate, const Joint& joint);
  void put(int coordinate, const Quadruple& q, const Quadruple& qd, const Quadruple& qdd);

  const DyadChain& chain_;
  const Model& m_;
  int crank_angle_, crank_joint_;  // indices in q of the crank's angle and of its joint's x
  std::vector<Place> places_;      // one for each dyad
  double size_;                    // nominal_size() of the model
  WideInstant now_;
  double condition_ = 0;
  // Errors of the joint solved last, divided by the unit roundoff: along its circle, passed on by
  // the dyads before; and in any direction, by the rounding of its own position. Both are lengths.
  double along_ = 0, any_way_ = 0;
};

}  // namespace desmo::extremes
