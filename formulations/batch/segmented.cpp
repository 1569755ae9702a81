#include "formulations/batch/segmented.h"

#include <utility>

#include "formulations/stepping/trajectory.h"

namespace desmo {

Segmented::Segmented(std::unique_ptr<TimeStepping> steps, std::unique_ptr<SegmentExecutor> executor)
    : Formulation(steps->model(), steps->tolerance()),
      steps_(std::move(steps)),
      executor_(std::move(executor)) {}

void Segmented::solve_only(std::span<const Level> needed) {
  executor_->solve_only(needed);
  steps_->solve_only(needed);
}

Summary Segmented::run(const TimeGrid& grid, const Request& request, Observer& observer) {
  if (grid.instants > 0 && steps_->assemble(grid.time(0), request.level).ok())
    if (const std::optional<Summary> total = run_on(grid, request, observer)) return *total;
  ++run_by_steps_;
  return steps_->run(grid, request, observer);
}

/// From the instant that was solved last: that of the grid's first, or another from which the
/// drivers can go there straight.
std::optional<Summary> Segmented::run_on(const TimeGrid& grid, const Request& request,
                                         Observer& observer) {
  const OutputWriter output(request, model().coordinates());
  const bool keeps = !observer.any_order() || observer.lent_at_once() == 0;
  std::optional<Trajectory> kept;
  if (keeps) kept.emplace(grid.instants, model().coordinates(), request.level);
  last_ = steps_->state();
  std::optional<Summary> total = keeps ? executor_->run(grid, {request.level}, last_, *kept)
                                       : executor_->run(grid, request, last_, observer);
  if (!total && !keeps) observer.restart();
  if (!total || total->stopped) return total;
  steps_->take(last_, grid.time(grid.instants - 1), request.level);
  if (!keeps) return total;
  total->instants = 0;
  for (const Instant& instant : kept->instants()) {
    ++total->instants;
    total->stopped = output.hand_over(instant, observer) == Flow::stop;
    if (total->stopped) break;
  }
  return total;
}

}  // namespace desmo
