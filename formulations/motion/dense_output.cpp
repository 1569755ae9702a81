#include "formulations/motion/dense_output.h"

#include <algorithm>
#include <utility>

#include "formulations/motion/time_stepping.h"

namespace desmo {

DenseOutput::DenseOutput(const TimeGrid& grid, int stride, const Request& request, int coordinates,
                         Observer& observer)
    : grid_(grid),
      stride_(stride),
      level_(request.level),
      ranges_(ranges_of(requested_coordinates(request, coordinates))),
      output_(request, coordinates),
      observer_(observer) {
  for (State* s : {&last_, &between_}) s->resize(coordinates);
}

Flow DenseOutput::observe(const Instant& solved) noexcept {
  Instant in_grid = solved;
  in_grid.index = std::min(solved.index * stride_, grid_.instants - 1);
  if (solved.index > 0 && interpolate_to(in_grid) == Flow::stop) return Flow::stop;
  const Flow flow = hand_on(in_grid);
  keep(in_grid);
  return flow;
}

// The quintic at s in Hermite's basis. 0 and 1 are the ends of an interval of h seconds:
//   q = q₀ + H₅ (q₁ − q₀) + h (H₁ q̇₀ + H₄ q̇₁) + h² (H₂ q̈₀ + H₃ q̈₁),  d/dt = d/ds / h.
// H₁ … H₅ and their first two derivatives are factored about their zeros at both ends, so that
// nothing cancels there.

DenseOutput::Weights DenseOutput::of_position(double s, double h) {
  const double r = 1 - s;
  return {.q0 = 1,
          .change = s * s * s * (10 + s * (-15 + 6 * s)),  // H₅
          .v0 = h * s * r * r * r * (1 + 3 * s),           // H₁
          .v1 = -h * s * s * s * r * (4 - 3 * s),          // H₄
          .a0 = h * h / 2 * s * s * r * r * r,             // H₂
          .a1 = h * h / 2 * s * s * s * r * r};            // H₃
}

DenseOutput::Weights DenseOutput::of_velocity(double s, double h) {
  const double r = 1 - s;
  return {.q0 = 0,
          .change = 30 / h * s * s * r * r,
          .v0 = r * r * (1 - 3 * s) * (1 + 5 * s),
          .v1 = -s * s * (2 - 3 * s) * (6 - 5 * s),
          .a0 = h / 2 * s * r * r * (2 - 5 * s),
          .a1 = h / 2 * s * s * r * (3 - 5 * s)};
}

DenseOutput::Weights DenseOutput::of_acceleration(double s, double h) {
  const double r = 1 - s;
  return {.q0 = 0,
          .change = 60 / (h * h) * s * r * (1 - 2 * s),
          .v0 = -12 / h * s * r * (3 - 5 * s),
          .v1 = -12 / h * s * r * (2 - 5 * s),
          .a0 = r * (1 - s * (8 - 10 * s)),
          .a1 = s * (3 - s * (12 - 10 * s))};
}

/// Hands on the instants between the last solved one and `next`. Weights are the same for every
/// coordinate: they are computed once for each instant.
Flow DenseOutput::interpolate_to(const Instant& next) {
  const int steps = next.index - last_index_;
  const double h = steps * grid_.interval();
  for (int k = 1; k < steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    combine(of_position(s, h), next, between_.q);
    if (level_ >= Level::velocity) combine(of_velocity(s, h), next, between_.qd);
    if (level_ >= Level::acceleration) combine(of_acceleration(s, h), next, between_.qdd);
    const int i = last_index_ + k;
    const Flow flow = hand_on({.index = i,
                               .time = grid_.time(i),
                               .q = between_.q,
                               .qd = between_.qd,
                               .qdd = between_.qdd,
                               .interpolated = true});
    if (flow == Flow::stop) return flow;
  }
  return Flow::go_on;
}

void DenseOutput::combine(Weights w, const Instant& next, std::vector<double>& result) const {
  const double *q0 = last_.q.data(), *v0 = last_.qd.data(), *a0 = last_.qdd.data();
  const double *q1 = next.q.data(), *v1 = next.qd.data(), *a1 = next.qdd.data();
  double* const y = result.data();
  for (const IndexRange range : ranges_)
    for (int i = range.first; i < range.end; ++i)
      y[i] = w.q0 * q0[i] + w.change * (q1[i] - q0[i]) + w.v0 * v0[i] + w.v1 * v1[i] +
             w.a0 * a0[i] + w.a1 * a1[i];
}

Flow DenseOutput::hand_on(const Instant& instant) {
  ++delivered_;
  Instant asked = instant;
  if (level_ < Level::velocity) asked.qd = {};
  if (level_ < Level::acceleration) asked.qdd = {};
  return output_.hand_over(asked, observer_);
}

void DenseOutput::keep(const Instant& solved) {
  for (const IndexRange range : ranges_)
    for (const auto& [from, to] :
         {std::pair{solved.q, &last_.q}, {solved.qd, &last_.qd}, {solved.qdd, &last_.qdd}})
      std::copy(from.begin() + range.first, from.begin() + range.end, to->begin() + range.first);
  last_index_ = solved.index;
}

/// Solves every stride-th instant and the last one, and interpolates the others.
Summary TimeStepping::run_with_stride(const TimeGrid& grid, const Request& request,
                                      Observer& observer) {
  const TimeGrid solved = grid.every(settings().stride);
  DenseOutput all(grid, settings().stride, request, model().coordinates(), observer);
  Summary total = solve_all(solved, {Level::acceleration, request.coordinates}, all);
  if (total.ok() && !total.stopped &&
      all.delivered() < grid.instants) {  // the last interval may be shorter than the stride
    const double t = grid.time(grid.instants - 1);
    const Summary last = step(t, Level::acceleration);
    total.add(last);
    if (last.ok())
      total.stopped = deliver(solved.instants, t, last, Level::acceleration, all) == Flow::stop;
  }
  total.instants = all.delivered();
  return total;
}

}  // namespace desmo
