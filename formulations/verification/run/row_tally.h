#pragma once

#include <map>

#include "formulations/verification/run/checked_run.h"
#include "formulations/verification/run/running_scales.h"

namespace desmo {

/// Tally of the rows of a checked run for its summary: flags, change points and largest radii.
class RowTally {
 public:
  /// The model must outlive this.
  RowTally(const Model& model, const TimeGrid& grid) : m_(model), scales_(model, grid) {}

  /// Includes a row, and writes its relative radii. Flags it if they leave no digit
  /// (RelativeRadius::proves_no_digit()).
  void take(CheckedInstant& row, CheckedSummary& summary);
  /// Writes the scales of the motion, and the largest radii over them.
  void finish(CheckedSummary& summary) const;

 private:
  void take_radius(CheckedInstant& row);
  void take_flag(const RowFlag& flag, CheckedSummary& summary);

  const Model& m_;
  RunningScales scales_;
  PerLevel<double> length_{}, rotation_{};  // largest radii of proven rows
  std::map<GroupId, double> last_point_;    // RowFlag::after of each group's last change point
};

}  // namespace desmo
