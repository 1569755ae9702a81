#pragma once

#include <optional>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"

namespace desmo {

/// Times of a grid, spread evenly, at which drivers are looked at beforehand [s].
std::vector<double> looks_ahead(const TimeGrid& grid);

/// The scales of a motion (see Scales) while it is being solved: at least those that its drivers
/// will have, and those of the instants so far, components standing for norms.
class RunningScales {
 public:
  /// given: scales that are known, and do not change.
  RunningScales(const Model& model, const TimeGrid& grid, const std::optional<Scales>& given = {});

  /// True when one of them has grown.
  bool take(const Instant& instant);
  const Scales& now() const { return now_; }
  /// What they would be with an instant that may turn out wrong.
  Scales with(const Instant& instant) const;

 private:
  bool are_given_;
  bool grow(Scales& seen, const Instant& instant) const;
  static Scales completed(Scales seen);

  std::vector<double> is_length_;  // of each coordinate: 1 or 0
  Scales seen_, now_;
};

}  // namespace desmo
