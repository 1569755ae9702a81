#pragma once

#include <algorithm>
#include <optional>

#include "formulations/motion/dense_output.h"
#include "formulations/verification/branch/growth.h"

namespace desmo {

/// The stride, the number of steps from one solved instant to the next, when a run goes on from its
/// last good instant. It is halved where the instant a stride ahead is not solved, and
/// doubled again as Growth has it.
class StrideControl {
 public:
  explicit StrideControl(int longest) : longest_(longest), now_(longest) {}

  int now() const { return now_; }
  void halve();
  /// Tells that all instants of an interval were handed on.
  void keep();

 private:
  int longest_, now_;
  Growth growth_;
};

/// Steps of a formulation with a stride (Settings::stride), after its own run has ended: finds the
/// instants to solve, and hands on those and the interpolated ones between.
class StridedSteps {
 public:
  /// rows: the observer that receives every instant, by its index in the grid. It and the
  /// formulation outlive this object.
  StridedSteps(Formulation& formulation, const TimeGrid& grid, Level level, Observer& rows);

  struct Step {
    Summary summary;
    Instant instant;  ///< the solved instant, or the one that failed
  };
  enum class From { estimate, last };
  /// Solves the instant a stride after the last, or the grid's last one. At first, after restart()
  /// and without a stride: the one of index `next`, the first not handed on. from: whether it is
  /// assembled from the model's estimate or stepped to from the last.
  Step solve(int next, From from);

  /// Hands on the interpolated instants since the last solved one, and this one. Stops where the
  /// observer `rows` does.
  Flow hand_on(const Instant& solved);
  /// Tells that the formulation was taken elsewhere, so there is nothing to interpolate from.
  void restart() { is_known_ = false; }
  void halve() { stride_.halve(); }

 private:
  Formulation& formulation_;
  const TimeGrid grid_;
  Observer& rows_;
  StrideControl stride_;
  std::optional<DenseOutput> between_;  // empty: without a stride
  const Level level_;                   // to which instants are solved
  bool is_known_ = false;               // the last solved instant
};

}  // namespace desmo
