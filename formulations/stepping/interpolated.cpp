#include "formulations/stepping/interpolated.h"

#include <utility>

#include "formulations/stepping/dense_output.h"

namespace desmo {

Interpolated::Interpolated(std::unique_ptr<Formulation> inner, int stride)
    : Formulation(inner->model(), inner->tolerance()), inner_(std::move(inner)), stride_(stride) {}

Summary Interpolated::run(const TimeGrid& grid, const Request& request, Observer& observer) {
  const TimeGrid solved = grid.every(stride_);
  DenseOutput all(grid, stride_, request, model().coordinates(), observer);
  Summary total = inner_->run(solved, {Level::acceleration, request.coordinates}, all);
  if (total.ok() && !total.stopped &&
      all.delivered() < grid.instants) {  // the rest, shorter than the stride
    const double t = grid.time(grid.instants - 1);
    const Summary last = inner_->step(t, Level::acceleration);
    total.add(last);
    if (last.ok())
      total.stopped = all.observe({.index = solved.instants,
                                   .time = t,
                                   .q = q(),
                                   .qd = qd(),
                                   .qdd = qdd(),
                                   .updates = last.updates,
                                   .residual = last.residual}) == Flow::stop;
  }
  total.instants = all.delivered();
  return total;
}

}  // namespace desmo
