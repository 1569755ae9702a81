// The instants that SegmentsInLanes hands to the observer.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "formulations/batch/layout.h"
#include "formulations/batch/segments_in_lanes.h"

namespace desmo {

/// Returns the outputs of step i, one for each lane that has an instant of the motion there. Where
/// none are left, borrows these and those of the next steps.
std::span<const OutputView> SegmentsInLanes::borrow(const TimeGrid& grid, int length, int i,
                                                    Observer& observer) {
  const auto count = [&](int step) {
    return std::min<std::size_t>(lanes_, (grid.instants - step + length - 1) / length);
  };
  if (used_ == outputs_.size()) {
    const int last = std::min(length, i + std::max(1, observer.lent_at_once() / lanes_));
    indices_.clear();
    for (int step = i; step < last; ++step)
      for (std::size_t l = 0; l < count(step); ++l)
        indices_.push_back(static_cast<int>(l) * length + step);
    outputs_.resize(indices_.size());
    observer.lend(indices_, outputs_);
    used_ = 0;
  }
  const std::size_t first = used_;
  used_ += count(i);
  return {&outputs_[first], count(i)};
}

void SegmentsInLanes::deliver(const TimeGrid& grid, int length, int i, Level level,
                              const StepInLanes& step, Observer& observer, Summary& total) {
  const std::span<const OutputView> lent = borrow(grid, length, i, observer);
  const auto unpack_level = [&](Level least, const LaneValues& from, double* OutputView::*to) {
    if (level < least || !(lent[0].*to)) return;
    std::array<double*, max_lanes> lanes;
    lanes.fill(beyond_.data());
    for (std::size_t l = 0; l < lent.size(); ++l) lanes[l] = lent[l].*to;
    unpack(from.data(), requested_, {lanes.data(), lanes.data() + lanes_});
  };
  unpack_level(Level::position, state_.now().q, &OutputView::q);
  unpack_level(Level::velocity, state_.now().qd, &OutputView::qd);
  unpack_level(Level::acceleration, state_.now().qdd, &OutputView::qdd);
  for (std::size_t l = 0; l < lent.size(); ++l) {
    const int index = static_cast<int>(l) * length + i;
    const auto values = [&](Level least, const double* output) {
      return std::span(output, output && level >= least ? requested_.size() : 0);
    };
    const Instant instant{.index = index,
                          .time = grid.time(index),
                          .q = values(Level::position, lent[l].q),
                          .qd = values(Level::velocity, lent[l].qd),
                          .qdd = values(Level::acceleration, lent[l].qdd),
                          .updates = step.updates,
                          .residual = std::sqrt(residual2_[l]),
                          .output = lent[l]};
    ++total.instants;
    total.iterations += step.iterations;
    total.updates += step.updates;
    total.stopped = observer.observe(instant) == Flow::stop;
    if (total.stopped) return;
  }
}

}  // namespace desmo
