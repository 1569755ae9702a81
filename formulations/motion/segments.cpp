#include "formulations/motion/segments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "formulations/base/output_writer.h"
#include "formulations/model/scales.h"
#include "formulations/motion/time_stepping.h"

namespace desmo {

namespace {

/// Maximum difference of segments that meet (≤). For points and distances it is relative to the
/// largest of their components. For other coordinates it is absolute, [1] or [rad].
constexpr double max_difference = 1e-6;

/// An observer that keeps the instants of a motion, for one that needs them in order or lends no
/// memory.
class MotionBuffer final : public Observer {
 public:
  /// coordinates: their number in an instant; all are requested, up to `level`.
  MotionBuffer(int instants, int coordinates, Level level)
      : instants_(instants),
        coordinates_(static_cast<std::size_t>(coordinates)),
        q_(instants_.size() * coordinates_),
        qd_(level >= Level::velocity ? q_.size() : 0),
        qdd_(level >= Level::acceleration ? q_.size() : 0) {}

  Flow observe(const Instant& instant) noexcept override {
    instants_[instant.index] = instant;
    return Flow::go_on;
  }
  int lent_at_once() const noexcept override { return static_cast<int>(instants_.size()); }
  void lend(std::span<const int> instants, std::span<OutputView> outputs) noexcept override {
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const auto of_instant = [&](std::vector<double>& values) {
        return values.empty() ? nullptr : &values[instants[i] * coordinates_];
      };
      outputs[i] = {of_instant(q_), of_instant(qd_), of_instant(qdd_)};
    }
  }
  bool any_order() const noexcept override { return true; }
  Observer* of_thread(int) noexcept override { return this; }

  /// Hands the instants over in order of time. Counts those that the observer took, and their
  /// updates.
  void hand_over(const OutputWriter& output, Observer& observer, Summary& total) const {
    total.instants = total.updates = 0;
    for (const Instant& instant : instants_) {
      ++total.instants;
      total.updates += instant.updates;
      total.stopped = output.hand_over(instant, observer) == Flow::stop;
      if (total.stopped) return;
    }
  }

 private:
  std::vector<Instant> instants_;
  std::size_t coordinates_;
  std::vector<double> q_, qd_, qdd_;  // values of all instants; empty above the level
};

}  // namespace

bool segments_meet(const Model& m, std::span<const double> ended, std::span<const double> begun) {
  double length = 0;
  for (const Entity& e : m.entities)
    for (int k = e.first; !e.fixed && is_length(e.kind) && k < e.first + e.size; ++k)
      length = std::max(length, std::abs(begun[k]));
  return std::ranges::all_of(m.entities, [&](const Entity& e) {
    const double allowed = max_difference * (is_length(e.kind) ? length : 1);
    for (int k = e.first; !e.fixed && k < e.first + e.size; ++k)
      if (!(std::abs(ended[k] - begun[k]) <= allowed)) return false;
    return true;
  });
}

/// Solves a motion in segments. Starts from the instant that was solved last: the first of the
/// grid, or another from which it can be reached by continuation.
std::optional<Summary> TimeStepping::solve_segments(const TimeGrid& grid, const Request& request,
                                                    Observer& observer) {
  const OutputWriter output(request, model().coordinates());
  const bool at_once = observer.any_order() && observer.lent_at_once() > 0;
  std::optional<MotionBuffer> buffer;
  if (!at_once) buffer.emplace(grid.instants, model().coordinates(), request.level);
  ended_ = now_.state;
  std::optional<Summary> total = at_once ? executor_->run(grid, request, ended_, observer)
                                         : executor_->run(grid, {request.level}, ended_, *buffer);
  if (!total && at_once) observer.restart();
  if (!total || total->stopped) return total;
  now_.state = ended_;  // later steps start from here
  forget_steps();
  now_.time = grid.time(grid.instants - 1);
  now_.level = request.level;
  if (buffer) buffer->hand_over(output, observer, *total);
  return total;
}

}  // namespace desmo
