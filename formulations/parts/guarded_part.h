#pragma once

#include <span>

#include "formulations/base/part.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// A part solved by generated code that monitors its pivots. A step that it refuses is solved by a
/// pivoting part.
class GuardedPart : public Part {
 public:
  /// Returns the number of steps left to the pivoting part, without assemblies, which start from
  /// estimates.
  virtual long fallbacks() const = 0;
  /// Returns fallbacks(): in each of these steps the pivoting part chose pivots anew.
  long refactorisations() const final { return fallbacks(); }
  /// Returns the number of these steps that ended on another branch than the step before, where the
  /// part can tell.
  virtual long branch_changes() const { return 0; }
  /// Sets whether Newton's method makes one more correction where the tolerance is met but ‖Φ‖ is
  /// above rounding. Monitored runs ask for it: the position's error is κ times as large as ‖Φ‖.
  virtual void correct_once_more(bool asked) { static_cast<void>(asked); }
};

/// One more correction of the parts of a formulation: asked for as long as this lives.
class OneMoreCorrection {
 public:
  explicit OneMoreCorrection(std::span<const DefinedPart> parts) : parts_(parts) { ask(true); }
  ~OneMoreCorrection() { ask(false); }
  OneMoreCorrection(const OneMoreCorrection&) = delete;
  OneMoreCorrection& operator=(const OneMoreCorrection&) = delete;

 private:
  void ask(bool asked) const {
    for (const DefinedPart& part : parts_)
      if (auto* const guarded = dynamic_cast<GuardedPart*>(part.solver.get()))
        guarded->correct_once_more(asked);
  }

  std::span<const DefinedPart> parts_;
};

}  // namespace desmo
