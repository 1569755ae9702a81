#pragma once

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"

namespace desmo {

/// The limit that keeps an instant from being as right as its tolerance asks for.
enum class Limit {
  singular_position,
  drivers,   ///< their motions, which are rounded where they come to large numbers or late
  origin,    ///< coordinates that are large compared with the mechanism
  sizes,     ///< lengths of different magnitudes in one mechanism
  rounding,  ///< of the equations, and nothing in particular
};

/// The accuracy of a solved instant, from its numbers alone.
struct Assessment {
  bool singular = false;  ///< the equations do not determine the position, to working precision
  /// Estimate of the condition number (verification/condition.h), within a factor of three;
  /// infinite where Φ_φ could not be factorised.
  double condition = 1;
  /// Bound on the error of any output, as verification/error.h measures it; infinite where
  /// singular. 0 beyond the level solved.
  PerLevel<double> bound;
  double rounding = 0;  ///< what bound.position would be if Φ were nothing but its rounding
  GroupId group = -1;   ///< of the unknown that the condition is worst for
  Limit limit = Limit::rounding;  ///< of an instant that is degraded
};

/// An interval after which the assembly branch is not the one that continuity and the estimate
/// declare, or is unknown.
struct SingularityCrossing {
  enum class Kind {
    passed,        ///< a singular position was passed: a block's determinant has changed its sign
    jumped,        ///< the later instant is not what the motion from the earlier one leads to
    not_declared,  ///< assembled with other signs of determinants than the estimate has, or too far
                   ///< from it for these to mean anything
  };
  double after, before;  ///< the ends of the interval [s]
  GroupId group;
  Kind kind;
};

/// An instant that conditioning does not let be as right as its tolerance asks for.
struct Degradation {
  int index;
  double time;  ///< s
  Assessment assessment;
};

}  // namespace desmo
