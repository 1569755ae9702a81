#pragma once

#include "cases/mechanism/motion.h"
#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

/// Scales of a motion (see Scales) while it is being solved. Those of rates start at the largest
/// rates of the drivers over the grid, or at 0 if it has no instants. Larger rates of an instant
/// raise them.
class RunningScales {
 public:
  /// The model must outlive this object.
  RunningScales(const Model& model, const TimeGrid& grid);

  /// Includes an instant.
  void take(const Instant& instant);
  Scales current() const;

 private:
  const Model& m_;
  Scales seen_;
};

}  // namespace desmo
