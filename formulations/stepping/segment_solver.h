#pragma once

#include <optional>

#include "formulations/base/part.h"
#include "formulations/formulation.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// A formulation that can also solve a segment in the middle of a motion.
class SegmentSolver : public Formulation {
 public:
  /// Runs like run(), but starts at the position that start_at() reached. Returns nothing where an
  /// instant could not be solved or segments do not meet; all that the observer was given is then
  /// void.
  virtual std::optional<Summary> run_on(const TimeGrid& grid, const Request& request,
                                        Observer& observer) = 0;

  const State& state() const override = 0;
  const std::vector<DefinedPart>& parts() const override = 0;

 protected:
  using Formulation::Formulation;
};

}  // namespace desmo
