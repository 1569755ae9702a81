#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/motion/time_stepping.h"

namespace desmo {

/// Solves equal segments of a motion, each on a thread of its own. The cut depends on the motion's
/// work and the settings alone, not on the number of processors or their load.
class SegmentsOnThreads final : public SegmentExecutor {
 public:
  /// workers: one for each thread, alike, of the model whose motion is solved; they share only what
  /// is const. min_instants: length of the shortest segment that is worth entering [instants].
  SegmentsOnThreads(std::vector<std::unique_ptr<TimeStepping>> workers, int min_instants);

  std::optional<Summary> run(const TimeGrid& grid, const Request& request, State& state,
                             Observer& observer) override;
  void solve_only(std::span<const Level> needed) override;

  /// Returns the number of segments into which a motion is cut: fewer than there are threads where
  /// each would have little to do. instants: of the motion.
  int segments(int instants) const;

 private:
  struct Segment;

  static void solve(Segment& segment, TimeStepping& worker, const TimeGrid& grid,
                    const Request& request, const State& first, Observer& observer);

  std::vector<std::unique_ptr<TimeStepping>> workers_;
  const int min_instants_;
  const long moving_unknowns_;
};

}  // namespace desmo
