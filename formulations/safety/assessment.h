#pragma once

#include "cases/mechanism.h"
#include "formulations/accuracy/per_level.h"

namespace desmo {

/// How right a solved instant is, from its numbers alone.
struct Assessment {
  bool singular = false;  ///< the equations do not determine the position, to working precision
  /// Estimate of the condition number (accuracy/condition.h), within a factor of three; infinite
  /// where Φ_φ could not be factorised.
  double condition = 1;
  /// Of the error of any output, as accuracy/error.h measures it; infinite where singular. 0 beyond
  /// the level solved.
  PerLevel<double> bound;
  double rounding = 0;  ///< what bound.position would be if Φ were nothing but its rounding
  GroupId group = -1;   ///< of the unknown that the condition is worst for
};

}  // namespace desmo
