#pragma once

#include <optional>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

/// Scales of a motion (see Scales) while it is being solved. They start from the drivers' rates and
/// grow with the instants so far.
class RunningScales {
 public:
  /// given: scales that are known, and do not change.
  RunningScales(const Model& model, const TimeGrid& grid, const std::optional<Scales>& given = {});

  /// Includes an instant.
  void take(const Instant& instant);
  const Scales& current() const { return scales_; }

 private:
  bool grow(const Instant& instant);
  static Scales completed(Scales seen);

  struct Moving {
    int first, size;  // coordinates
    bool is_length;
  };
  bool are_given_;
  std::vector<Moving> moving_;
  Scales seen_, scales_;
};

}  // namespace desmo
