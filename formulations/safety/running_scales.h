#pragma once

#include <vector>

#include "formulations/accuracy/scales.h"
#include "formulations/formulation.h"

namespace desmo {

/// The scales of a motion (see Scales) while it is being solved: at least those that its drivers
/// will have, and those of the instants so far, components standing for norms.
class RunningScales {
 public:
  RunningScales(const Mechanism& mechanism, const TimeGrid& grid);

  /// True when one of them has grown.
  bool take(const Instant& instant);
  const Scales& now() const { return now_; }

 private:
  void complete();

  std::vector<double> is_length_;  // of each coordinate: 1 or 0
  Scales seen_, now_;
};

}  // namespace desmo
