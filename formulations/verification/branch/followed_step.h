#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// End of a followed motion.
enum class PathEnd {
  same,   ///< at the time that was asked for, in the instant that was handed in, if one was
  other,  ///< at that time, but elsewhere: the instant is on another branch
  stuck,  ///< before it: the motion locks, passes a singular position, or takes too many tests
};

/// Report on a step that was followed.
struct FollowedStep {
  PathEnd end = PathEnd::stuck;
  int tests = 0;                ///< path proofs
  int sub_steps = 0;            ///< that are proven; 1, if not stuck: proven at the first try
  double time = 0;              ///< of the last proven instant [s]
  GroupId group = no_position;  ///< stuck: that of the last failed proof, or an earlier one that
                                ///< is nearly singular
  bool out_of_tests = false;    ///< stuck: the budget ended; a smaller step may lead on
};

}  // namespace desmo
