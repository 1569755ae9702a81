#pragma once

#include "formulations/base/part.h"

namespace desmo {

/// A part solved by generated code that watches itself: what it refuses is left to a part that
/// pivots.
class GuardedPart : public Part {
 public:
  /// Returns how many steps were left to it. Assemblies, which start from estimates, do not count.
  virtual long fallbacks() const = 0;
  long refactorisations() const final { return fallbacks(); }
  /// Returns how many of them came out on another branch, where branches are kept.
  virtual long branch_changes() const { return 0; }
};

}  // namespace desmo
