#pragma once

#include <cstddef>
#include <vector>

#include "formulations/base/live_row.h"
#include "formulations/base/per_level.h"
#include "formulations/model/model.h"

namespace desmo {

/// Motions of drivers that are known in rows alone. Between two rows they are polynomials: quintics
/// if the rows have accelerations, cubics if they have velocities, else straight lines. The later
/// row has time 0, where the polynomial has its numbers exactly. The radius of the last coefficient
/// is so large that the position of the earlier row is enclosed, too.
class RowMotions {
 public:
  /// Copies the model, whose own motions are not used. level: the highest level of the rows.
  RowMotions(const Model& model, Level level);

  /// Returns the model with the present motions.
  const Model& model() const { return model_; }

  /// Forgets the earlier row: motions are then Taylor's polynomials of the later one.
  void forget() { has_begun_ = false; }
  /// Makes a row the earlier one.
  void begin_at(const LiveRow& row);
  bool has_begun() const { return has_begun_; }
  /// Shifts the earlier row by a time [s].
  void shift_time(double later) { time_ += later; }

  /// Sets the motions from the earlier row to a later one. Returns the time of the earlier row [s],
  /// counted from the later one and thus negative; 0 if there is none.
  double lead_to(const LiveRow& row);

 private:
  void lead_driver(std::size_t driver, const LiveRow& row, double begin);

  Model model_;
  Level level_;
  // z, ż and z̈ of each driver at the earlier row, up to level_
  PerLevel<std::vector<double>> from_;
  double time_ = 0;
  bool has_begun_ = false;
};

}  // namespace desmo
