#pragma once

#include <span>
#include <vector>

#include "cases/generators/dyad_chain.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo::extremes {

/// The motion of a chain of dyads in quadruple precision by a closed form, the intersection of two
/// circles a dyad. It shares nothing with any formulation but the motion of the crank.
class ChainSolution {
 public:
  /// mechanism: of the chain and nothing else. Both must outlive the solution.
  ChainSolution(const DyadChain& chain, const Model& model);

  /// The branch of each dyad is the one on whose side its joint is in these positions; angles are
  /// those nearest to these, and then to those before. At first the mechanism's estimate holds.
  void declare(std::span<const double> q);

  /// Solves at time t [s]. Returns false where there is no answer: the crank's angle is no number,
  /// a dyad cannot be closed, or it is stretched or folded so that its rates are not determined.
  bool solve(double t);

  /// Returns the instant solved last.
  ReferenceInstant instant() const { return rounded(now_); }

  /// Returns the sensitivity of the instant solved last to rounding: the change of its positions,
  /// to first order, when every length and every joint on the way is rounded to double. It is
  /// relative to the unit roundoff and the size.
  double condition() const { return condition_; }

 private:
  struct Joint {
    Quadruple x, y, vx, vy, ax, ay;
  };
  struct Place {
    int joint, angle;  // coordinates
    int side;
    double last_angle;
  };

  bool close(std::size_t dyad, const Joint& from, Joint& to);
  void put(int coordinate, const Joint& joint);
  void put(int coordinate, const Quadruple& q, const Quadruple& qd, const Quadruple& qdd);

  const DyadChain& chain_;
  const Model& m_;
  int crank_angle_, crank_joint_;  // coordinates
  std::vector<Place> places_;      // of the dyads
  double size_;
  WideInstant now_;
  double condition_ = 0;
  double along_ = 0, any_way_ = 0;  // error of the joint at hand over the unit roundoff: length
};

}  // namespace desmo::extremes
