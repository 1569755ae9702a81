#include "formulations/verification/run/strided_steps.h"

#include <utility>

namespace desmo {

void StrideControl::halve() {
  growth_.failed();
  now_ = std::max(1, now_ / 2);
}

void StrideControl::keep() {
  if (growth_.succeeded()) now_ = std::min(2 * now_, longest_);
}

StridedSteps::StridedSteps(Formulation& f, const TimeGrid& grid, Level level, Observer& rows)
    : formulation_(f),
      grid_(grid),
      rows_(rows),
      stride_(f.settings().stride),
      level_(f.settings().stride > 1 ? Level::acceleration : level) {
  if (f.settings().stride > 1)
    between_.emplace(grid, f.settings().stride, Request{level}, f.model().coordinates(), rows);
}

StridedSteps::Step StridedSteps::solve(int next, From from) {
  const int index = is_known_ ? std::min(next + stride_.now() - 1, grid_.instants - 1) : next;
  const double t = grid_.time(index);
  Formulation& f = formulation_;
  const Summary s = from == From::estimate ? f.assemble(t, level_) : f.step(t, level_);
  const auto to = [&](Level level, std::span<const double> rates) {
    return level_ >= level ? rates : std::span<const double>();
  };
  return {s,
          {index, t, f.q(), to(Level::velocity, f.qd()), to(Level::acceleration, f.qdd()),
           s.updates, s.residual}};
}

Flow StridedSteps::hand_on(const Instant& solved) {
  if (!between_) return rows_.observe(solved);  // without a stride
  if (!std::exchange(is_known_, true)) return between_->start_at(solved);
  const Flow flow = between_->go_to(solved);
  if (flow == Flow::go_on) stride_.keep();
  return flow;
}

}  // namespace desmo
