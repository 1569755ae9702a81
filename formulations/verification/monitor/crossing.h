#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// An instant from which the assembly branch is not the one that continuity and the estimate
/// declare, or is unknown.
struct Crossing {
  enum class Kind {
    passed,        ///< a singular position: a block's determinant has changed its sign
    jumped,        ///< the later instant is not what the motion from the earlier leads to
    not_declared,  ///< assembled with other signs of determinants than the estimate has, or too far
                   ///< from it for these to mean anything
  };
  double after, before;  ///< s
  GroupId group;
  Kind kind;
};

}  // namespace desmo
