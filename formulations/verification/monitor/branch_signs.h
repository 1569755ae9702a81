#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/assessment.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Check of whether a motion stays on the assembly branch that the model's initial estimate
/// declares. It compares the signs of the determinants of irreducible blocks between assessed
/// instants.
class BranchSigns {
 public:
  /// The model and the system must outlive this object.
  BranchSigns(const Model& model, ScaledSystem& system) : model_(model), system_(system) {}

  /// Stores the signs at the initial estimate with the drivers of the first instant. Overwrites the
  /// system's factors.
  void declare(const Instant& first);
  /// Stores the signs at the first instant, which is known to be on the branch declared. The system
  /// holds its factors.
  void begin();

  /// Returns the crossing, if any, that the first assessed instant shows. The system holds its
  /// factors. sensitivity: the largest one to any driver (SensitivityMonitor::largest()).
  std::optional<SingularityCrossing> at_first(const Instant& instant, const Assessment& assessment,
                                              double sensitivity);
  /// Returns the crossing, if any, after an interval that could not be assembled.
  std::optional<SingularityCrossing> after_gap(const Instant& instant) {
    return change(instant.time, {});
  }
  /// Returns the crossing, if any, since the last assessed instant. last: its time [s].
  std::optional<SingularityCrossing> since(double last, const Instant& instant) {
    return change(instant.time, last);
  }
  /// Makes the signs found last those to compare with: their instant is delivered.
  void accept();
  /// Takes back the last accept().
  void take_back() { signs_ = before_; }
  /// Returns a block whose sign in the system differs from the one to compare with; -1: none.
  /// Keeps both signs.
  int changed_block() const;

 private:
  std::optional<SingularityCrossing> change(double time, std::optional<double> since);
  bool is_near_estimate(const Instant& instant, double condition, double sensitivity) const;

  const Model& model_;
  ScaledSystem& system_;
  std::vector<signed char> signs_;  // of the last instant accepted
  std::vector<signed char> found_, before_;
};

}  // namespace desmo
