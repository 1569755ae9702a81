#pragma once

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"

namespace desmo {

/// Cause that keeps an instant from being as accurate as its tolerance asks for.
enum class Limit {
  singular_position,
  drivers,   ///< rounding of the drivers' motions, whose values or times are large
  origin,    ///< coordinates that are large compared with the mechanism
  sizes,     ///< lengths of different magnitudes in one mechanism
  rounding,  ///< rounding of the equations, and no particular cause
};

/// Accuracy of a solved instant, found from its numbers alone.
struct Assessment {
  bool singular = false;  ///< the equations do not determine the position, to working precision
  /// Estimate of the condition number (verification/condition.h), within a factor of three.
  /// Infinity where Φ_φ could not be factorised.
  double condition = 1;
  /// Bound on the error of any output, measured as in verification/error.h. Infinity where
  /// singular, 0 at levels that were not solved.
  PerLevel<double> bound;
  double rounding = 0;          ///< bound.position if Φ were nothing but its rounding
  double per_residual = 0;      ///< bound.position over ‖Φ‖₂ (Settings::tolerance), at worst
  GroupId group = no_position;  ///< group of the unknown with the worst condition, if known
  Limit limit = Limit::rounding;  ///< cause, set for degraded instants only
};

/// Interval after which the assembly branch is unknown, or is not the one that continuity and the
/// initial estimate declare. A branch is one of the positions in which a mechanism can be
/// assembled.
struct SingularityCrossing {
  enum class Kind {
    passed,        ///< a singular position: a block's determinant changed its sign
    jumped,        ///< the motion from the earlier instant does not lead to the later one
    not_declared,  ///< the first position has other signs of determinants than the initial
                   ///< estimate, or is too far from it for the signs to mean anything
  };
  double after, before;  ///< the ends of the interval [s]
  GroupId group;
  Kind kind;
};

/// Instant that conditioning keeps from being as accurate as its tolerance asks for.
struct Degradation {
  int index;    ///< index in the grid
  double time;  ///< [s]
  Assessment assessment;
};

}  // namespace desmo
