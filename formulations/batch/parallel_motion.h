#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/batch/segmented.h"

namespace desmo {

/// Runs through a motion in equal stretches, each on a thread of its own. A stretch is entered from
/// the motion's first position along a way on which the drivers go straight; that it lies on the
/// same branch shows at the end of the stretch before, where both must agree. How a motion is cut
/// depends on its work alone, so that results do not depend on the machine or its load.
class ParallelMotion final : public SegmentExecutor {
 public:
  /// workers: one for each thread, alike, of the mechanism of which this is the motion; each is
  /// used by one thread at a time and shares nothing with the others but what is const.
  /// min_instants: of a stretch that is worth entering.
  ParallelMotion(std::vector<std::unique_ptr<Formulation>> workers, int min_instants);

  std::optional<Summary> run(const TimeGrid& grid, const Request& request, State& state,
                             Observer& observer) override;
  void solve_only(std::span<const Level> needed) override;

  /// Into how many stretches a motion of so many instants is cut: fewer than there are threads
  /// where each would have little to do.
  int stretches(int instants) const;

 private:
  struct Shared;
  class StretchObserver;

  /// A part of the motion, and what became of it.
  struct Stretch {
    int begin = 0, end = 0;        // instants of the grid
    std::vector<double> entered;   // position at its first instant, in coordinate order
    bool ended = false;            // the worker stands where the next one begins
    std::optional<Summary> total;  // nothing: it has to be done step by step
    std::exception_ptr error;
  };

  void solve(int k, const TimeGrid& grid, const Request& request, const State& first,
             Observer& observer);
  bool meet(int k) const;

  std::vector<std::unique_ptr<Formulation>> workers_;
  std::vector<Stretch> stretches_;
  const int min_instants_;
  const long moving_unknowns_;
};

}  // namespace desmo
