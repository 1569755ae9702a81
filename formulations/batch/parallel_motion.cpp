#include "formulations/batch/parallel_motion.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <utility>

#ifdef __linux__
#include <sched.h>
#endif

#include "formulations/batch/same_position.h"

namespace desmo {

namespace {

/// Unknowns times instants of a stretch: some ten times the work that takes as long as a thread
/// takes to begin.
constexpr long min_work = 100'000;

long moving_unknowns(const Formulation& f) {
  long sum = 0;
  for (const DefinedPart& part : f.parts())
    if (!part.definition.constant) sum += static_cast<long>(part.definition.unknowns.size());
  return sum;
}

/// On which the calling thread is, from 1; where nobody knows, another for each.
int processor() {
#ifdef __linux__
  if (const int known = sched_getcpu(); known >= 0) return known + 1;
#endif
  return omp_get_thread_num() + 1;
}

bool all_differ(const std::vector<std::atomic<int>>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (numbers[i] == numbers[j]) return false;
  return true;
}

/// Makes the threads on which motions will be solved. New ones may share a processor while another
/// has nothing to do, for longer than a motion takes: they are kept busy until the system has
/// spread them, or until that takes too long.
void start_threads(int count) {
  constexpr std::chrono::milliseconds too_long{30};
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::atomic<int>> on(count);
#pragma omp parallel num_threads(count)
  {
    const bool may_spread = omp_get_num_threads() == count && count <= omp_get_num_procs();
    do on[omp_get_thread_num()] = processor();
    while (may_spread && !all_differ(on) && std::chrono::steady_clock::now() - begin < too_long);
  }
}

/// Instants of a grid from `begin` on, up to `end`, which is not among them: at their times but for
/// rounding.
TimeGrid cut(const TimeGrid& grid, int begin, int end) {
  return {grid.time(begin), grid.step, end - begin, grid.stride};
}

}  // namespace

/// Hands instants of a stretch on as those of the whole motion, one thread after the other.
class ParallelMotion::SharedObserver final : public Observer {
 public:
  SharedObserver(Observer& observer, std::mutex& mutex, const TimeGrid& grid, int begin)
      : observer_(observer), mutex_(mutex), grid_(grid), begin_(begin), rooms_(observer.rooms()) {
    if (rooms_) rooms_->at_once = handed_on_together;
  }

  void observe(const Instant& of_stretch) override {
    waiting_.push_back(of_stretch);
    waiting_.back().index += begin_;
    waiting_.back().time = grid_.time(waiting_.back().index);
    if (!of_stretch.in_room()) hand_on();  // it holds until the next
  }
  /// Those that are left, too.
  void hand_on() {
    const std::scoped_lock lock(mutex_);
    hand_on_alone();
  }
  std::optional<RoomShape> rooms() const override { return rooms_; }
  /// Hands on as well: threads wait less often, and an observer may give the same rooms again,
  /// whose memory this thread has at hand.
  void take_rooms(std::span<const int> indices, std::span<Room> rooms) override {
    indices_.assign(indices.begin(), indices.end());
    for (int& index : indices_) index += begin_;
    const std::scoped_lock lock(mutex_);
    hand_on_alone();
    observer_.take_rooms(indices_, rooms);
  }
  bool takes_any_order() const override { return true; }

 private:
  void hand_on_alone() {
    for (const Instant& instant : waiting_) observer_.observe(instant);
    waiting_.clear();
  }

  /// Waiting for another thread takes as long as solving some instants.
  static constexpr int handed_on_together = 32;

  Observer& observer_;
  std::mutex& mutex_;
  const TimeGrid& grid_;
  const int begin_;
  std::optional<RoomShape> rooms_;
  std::vector<Instant> waiting_;  // in rooms
  std::vector<int> indices_;      // of rooms that are taken
};

ParallelMotion::ParallelMotion(std::vector<std::unique_ptr<Formulation>> workers, int min_instants)
    : workers_(std::move(workers)),
      stretches_(workers_.size()),
      min_instants_(min_instants),
      moving_unknowns_(moving_unknowns(*workers_.front())) {
  start_threads(static_cast<int>(workers_.size()));
}

void ParallelMotion::solve_only(std::span<const Level> needed) {
  for (const auto& worker : workers_) worker->solve_only(needed);
}

int ParallelMotion::stretches(int instants) const {
  const long worth =
      std::min(instants * moving_unknowns_ / min_work, static_cast<long>(instants) / min_instants_);
  return static_cast<int>(std::clamp<long>(worth, 1, std::ssize(workers_)));
}

std::optional<Summary> ParallelMotion::run(const TimeGrid& grid, const Request& request,
                                           State& state, Observer& observer) {
  const int count = stretches(grid.instants);
  std::mutex mutex;
  for (int k = 0; k < count; ++k) {
    stretches_[k].begin = static_cast<int>(static_cast<long>(k) * grid.instants / count);
    stretches_[k].end = static_cast<int>((k + 1L) * grid.instants / count);
  }
#pragma omp parallel for num_threads(count) schedule(static, 1)
  for (int k = 0; k < count; ++k) {
    try {
      SharedObserver shared(observer, mutex, grid, stretches_[k].begin);
      solve(k, grid, request, state, shared);
      shared.hand_on();
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
                           Observer& observer) {
  Stretch& s = stretches_[k];
  s.total.reset();
  s.error = nullptr;
  s.ended = false;
  Formulation& worker = *workers_[k];
  if (!worker.start_at(first.q, grid.time(s.begin))) return;
  s.entered.assign(worker.q().begin(), worker.q().end());
  s.total = worker.run_on(cut(grid, s.begin, s.end), request, observer);
  if (s.total && s.end < grid.instants)
    s.ended = worker.step(grid.time(s.end), Level::position).ok();
}

/// Whether a stretch ended where the next had begun.
bool ParallelMotion::meet(int k) const {
  return stretches_[k].ended &&
         same_position(workers_[k]->model(), workers_[k]->q(), stretches_[k + 1].entered);
}

}  // namespace desmo
