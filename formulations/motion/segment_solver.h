#pragma once

#include <optional>

#include "formulations/motion/formulation_core.h"

namespace desmo {

/// A formulation that can also solve a segment in the middle of a motion.
class SegmentSolver : public FormulationCore {
 public:
  /// Runs like run(), but starts at the position that start_at() reached. Returns nothing where an
  /// instant could not be solved or segments do not meet; all that the observer was given is then
  /// void.
  virtual std::optional<Summary> run_on(const TimeGrid& grid, const Request& request,
                                        Observer& observer) = 0;

 protected:
  using FormulationCore::FormulationCore;
};

}  // namespace desmo
