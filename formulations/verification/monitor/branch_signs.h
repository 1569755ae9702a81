#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/monitor/assessment.h"
#include "formulations/verification/monitor/scaled_system.h"

namespace desmo {

/// Tells whether a motion stays on the assembly branch that its mechanism's estimate declares, by
/// the signs of the determinants of irreducible blocks, from one assessed instant to the next.
class BranchSigns {
 public:
  /// Both must outlive it.
  BranchSigns(const Model& model, ScaledSystem& system) : model_(model), system_(system) {}

  /// The estimate, with the drivers of the first instant, has the signs that this should have.
  /// Overwrites what the system has factorised.
  void declare(const Instant& first);

  /// Returns the crossing that an assessed instant shows; the system has its factors. sensitivity:
  /// the largest to any driver (SensitivityMonitor::largest).
  std::optional<SingularityCrossing> at_first(const Instant& instant, const Assessment& assessment,
                                              double sensitivity);
  /// After an interval that was left out.
  std::optional<SingularityCrossing> after_gap(const Instant& instant) {
    return change(instant.time, {});
  }
  /// last: the time of the instant assessed before [s].
  std::optional<SingularityCrossing> since(double last, const Instant& instant) {
    return change(instant.time, last);
  }

 private:
  std::optional<SingularityCrossing> change(double time, std::optional<double> since);
  bool is_near_estimate(const Instant& instant, double condition, double sensitivity) const;

  const Model& model_;
  ScaledSystem& system_;
  std::vector<signed char> signs_;
};

}  // namespace desmo
