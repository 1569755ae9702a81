#include "formulations/parallel_motion.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "formulations/same_position.h"

namespace desmo {

namespace {

/// Unknowns times instants of a stretch: some ten times the work that takes as long as a thread
/// takes to begin.
constexpr long least_work = 100'000;

long moving_unknowns(const Formulation& f) {
  long sum = 0;
  for (const Formulation::DefinedPart& part : f.parts())
    if (!part.definition.constant) sum += static_cast<long>(part.definition.unknowns.size());
  return sum;
}

/// Instants of a grid from `begin` on, up to `end`, which is not among them: at their times but for
/// rounding.
TimeGrid cut(const TimeGrid& grid, int begin, int end) {
  return {grid.time(begin), grid.step, end - begin, grid.stride};
}

}  // namespace

/// Hands instants of a stretch on as those of the whole motion, one thread after the other.
class ParallelMotion::SharedSink final : public Sink {
 public:
  /// coordinates: of the mechanism.
  SharedSink(Sink& sink, std::mutex& mutex, const TimeGrid& grid, int begin, int coordinates)
      : sink_(sink), mutex_(mutex), grid_(grid), begin_(begin) {
    if (const std::optional<RoomShape> shape = sink_.rooms())
      rooms_.emplace(*shape, shape->coordinates.empty() ? static_cast<std::size_t>(coordinates)
                                                        : shape->coordinates.size());
  }

  void accept(const Instant& of_stretch) override {
    Instant instant = of_stretch;
    instant.index += begin_;
    instant.time = grid_.time(instant.index);
    const std::scoped_lock lock(mutex_);
    if (instant.in_room) {
      const Room from = rooms_->give_back();
      const Room to = sink_.room(instant.index);
      for (const auto values : {&Room::q, &Room::qd, &Room::qdd})
        if (to.*values) std::copy_n(from.*values, rooms_->size(), to.*values);
    }
    sink_.accept(instant);
  }
  std::optional<RoomShape> rooms() const override {
    return rooms_ ? std::optional(rooms_->shape()) : std::nullopt;
  }
  Room room(int) override { return rooms_->take(); }
  bool takes_any_order() const override { return true; }

 private:
  Sink& sink_;
  std::mutex& mutex_;
  const TimeGrid& grid_;
  const int begin_;
  std::optional<RoomRing> rooms_;  // of its own: the sink's are for one thread at a time
};

ParallelMotion::ParallelMotion(std::vector<std::unique_ptr<Formulation>> workers,
                               int least_instants)
    : workers_(std::move(workers)),
      stretches_(workers_.size()),
      least_instants_(least_instants),
      moving_unknowns_(moving_unknowns(*workers_.front())) {}

void ParallelMotion::solve_only(std::span<const Level> needed) {
  for (const auto& worker : workers_) worker->solve_only(needed);
}

int ParallelMotion::stretches(int instants) const {
  const long worth = std::min(instants * moving_unknowns_ / least_work,
                              static_cast<long>(instants) / least_instants_);
  return static_cast<int>(std::clamp<long>(worth, 1, std::ssize(workers_)));
}

std::optional<Summary> ParallelMotion::run(const TimeGrid& grid, const Request& request,
                                           State& state, Sink& sink) {
  const int count = stretches(grid.instants);
  std::mutex mutex;
  for (int k = 0; k < count; ++k) {
    stretches_[k].begin = static_cast<int>(static_cast<long>(k) * grid.instants / count);
    stretches_[k].end = static_cast<int>((k + 1L) * grid.instants / count);
  }
#pragma omp parallel for num_threads(count) schedule(static, 1)
  for (int k = 0; k < count; ++k) {
    SharedSink shared(sink, mutex, grid, stretches_[k].begin,
                      workers_[k]->mechanism().coordinates());
    try {
      solve(k, grid, request, state, shared);
    } catch (...) {  // must not leave its thread
      stretches_[k].error = std::current_exception();
    }
  }
  Summary whole;
  for (int k = 0; k < count; ++k) {
    const Stretch& s = stretches_[k];
    if (s.error) std::rethrow_exception(s.error);
    if (!s.total || (k + 1 < count && !meet(k))) return {};
    whole.instants += s.total->instants;
    whole.iterations += s.total->iterations;
    whole.updates += s.total->updates;
    whole.residual = std::max(whole.residual, s.total->residual);
  }
  whole.time = grid.time(grid.instants - 1);
  const Formulation& last = *workers_[count - 1];
  std::ranges::copy(last.q(), state.q.begin());
  std::ranges::copy(last.qd(), state.qd.begin());
  std::ranges::copy(last.qdd(), state.qdd.begin());
  return whole;
}

void ParallelMotion::solve(int k, const TimeGrid& grid, const Request& request, const State& first,
                           Sink& sink) {
  Stretch& s = stretches_[k];
  s.total.reset();
  s.error = nullptr;
  s.ended = false;
  Formulation& worker = *workers_[k];
  if (!worker.enter(first.q, grid.time(s.begin))) return;
  s.entered.assign(worker.q().begin(), worker.q().end());
  s.total = worker.run_on(cut(grid, s.begin, s.end), request, sink);
  if (s.total && s.end < grid.instants)
    s.ended = worker.step(grid.time(s.end), Level::position).ok();
}

/// Whether a stretch ended where the next had begun.
bool ParallelMotion::meet(int k) const {
  return stretches_[k].ended &&
         same_position(workers_[k]->mechanism(), workers_[k]->q(), stretches_[k + 1].entered);
}

}  // namespace desmo
