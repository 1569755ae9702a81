#include "formulations/batch/segments_on_threads.h"

#include <omp.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <utility>

namespace desmo {

namespace {

/// Minimum work of a segment (≥): moving unknowns times instants. Work of this size takes some ten
/// times as long as a thread takes to begin.
constexpr long min_work = 100'000;

long moving_unknowns(const TimeStepping& f) {
  long sum = 0;
  for (const DefinedPart& part : f.parts())
    if (!part.definition.constant) sum += static_cast<long>(part.definition.unknowns.size());
  return sum;
}

bool all_differ(const std::vector<std::atomic<int>>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (numbers[i] == numbers[j]) return false;
  return true;
}

/// Starts the threads on which motions will be solved. New threads may share a processor for longer
/// than a motion takes, while another processor is idle. They are kept busy until each has a
/// processor of its own, or until that takes too long.
void start_threads(int count) {
  constexpr std::chrono::milliseconds too_long{30};
  const auto begin = std::chrono::steady_clock::now();
  // number of each thread's processor, from 1; 0: not known yet
  std::vector<std::atomic<int>> on(count);
#pragma omp parallel num_threads(count)
  {
    const bool may_spread = omp_get_num_threads() == count && count <= omp_get_num_procs();
    do on[omp_get_thread_num()] = sched_getcpu() + 1;
    while (may_spread && !all_differ(on) && std::chrono::steady_clock::now() - begin < too_long);
  }
}

/// Returns a grid of the instants `begin` … `end` − 1, whose times are the same except for
/// rounding.
TimeGrid cut(const TimeGrid& grid, int begin, int end) {
  return {grid.time(begin), grid.step, end - begin, grid.steps_per_interval};
}

/// State that the threads share.
struct Shared {
  std::mutex mutex{};                // locks the observer
  std::atomic<bool> stopped{false};  // the observer has stopped the run
};

/// Hands instants of a segment on as those of the whole motion. They go to the thread's own
/// observer or, several at a time, to one that all threads share.
class SegmentObserver final : public Observer {
 public:
  SegmentObserver(Observer& all, int thread, Shared& shared, const TimeGrid& grid, int begin)
      : own_(all.of_thread(thread)),
        observer_(own_ ? *own_ : all),
        shared_(shared),
        grid_(grid),
        begin_(begin) {}

  Flow observe(const Instant& of_segment) noexcept override {
    waiting_.push_back(of_segment);
    waiting_.back().index += begin_;
    waiting_.back().time = grid_.time(waiting_.back().index);
    if (own_) hand_on_alone();
    return shared_.stopped ? Flow::stop : Flow::go_on;
  }
  /// Hands on the instants that still wait.
  void hand_on() noexcept {
    const std::unique_lock lock = wait();
    hand_on_alone();
  }
  int lent_at_once() const noexcept override {
    return own_ ? own_->lent_at_once() : handed_on_together;
  }
  /// Hands on waiting instants before it borrows memory. So threads wait less often, and an
  /// observer may lend the same memory again, which is in this thread's cache.
  void lend(std::span<const int> instants, std::span<OutputView> outputs) noexcept override {
    instants_.assign(instants.begin(), instants.end());
    for (int& instant : instants_) instant += begin_;
    const std::unique_lock lock = wait();
    hand_on_alone();
    observer_.lend(instants_, outputs);
  }
  bool any_order() const noexcept override { return true; }

  /// Returns the sums over the instants that were handed on: their number and updates.
  const Summary& handed_on() const { return handed_on_; }

 private:
  std::unique_lock<std::mutex> wait() const {
    return own_ ? std::unique_lock<std::mutex>() : std::unique_lock(shared_.mutex);
  }
  void hand_on_alone() {
    for (const Instant& instant : waiting_) {
      if (shared_.stopped) break;
      ++handed_on_.instants;
      handed_on_.updates += instant.updates;
      if (observer_.observe(instant) == Flow::stop) shared_.stopped = true;
    }
    waiting_.clear();
  }

  /// Number of instants for which a worker may borrow memory at once. They are handed on together:
  /// waiting for another thread takes as long as solving some.
  static constexpr int handed_on_together = 32;

  Observer* const own_;
  Observer& observer_;
  Shared& shared_;
  const TimeGrid& grid_;
  const int begin_;
  std::vector<Instant> waiting_;
  std::vector<int> instants_;  // indices of the instants for which memory is borrowed
  Summary handed_on_;
};

}  // namespace

/// A segment and the outcome of solving it.
struct SegmentsOnThreads::Segment {
  int begin, end;                        // range of instants in the grid
  std::vector<double> first_position{};  // at its first instant, in coordinate order
  bool ended = false;                    // whether the next segment's first instant is solved
  std::optional<Summary> total{};        // nothing: it could not be solved
  Summary handed_on{};                   // see SegmentObserver::handed_on()
  std::exception_ptr error{};
};

SegmentsOnThreads::SegmentsOnThreads(std::vector<std::unique_ptr<TimeStepping>> workers,
                                     int min_instants)
    : workers_(std::move(workers)),
      min_instants_(min_instants),
      moving_unknowns_(moving_unknowns(*workers_.front())) {
  start_threads(static_cast<int>(workers_.size()));
}

void SegmentsOnThreads::solve_only(std::span<const Level> needed) {
  for (const auto& worker : workers_) worker->solve_only(needed);
}

int SegmentsOnThreads::segments(int instants) const {
  const long worth =
      std::min(instants * moving_unknowns_ / min_work, static_cast<long>(instants) / min_instants_);
  return static_cast<int>(std::clamp<long>(worth, 1, std::ssize(workers_)));
}

std::optional<Summary> SegmentsOnThreads::run(const TimeGrid& grid, const Request& request,
                                              State& state, Observer& observer) {
  const int count = segments(grid.instants);
  std::vector<Segment> all;
  for (long k = 0; k < count; ++k)
    all.push_back({static_cast<int>(k * grid.instants / count),
                   static_cast<int>((k + 1) * grid.instants / count)});
  Shared shared;
#pragma omp parallel for num_threads(count) schedule(static, 1)
  for (int k = 0; k < count; ++k) {
    Segment& s = all[k];
    try {
      SegmentObserver own(observer, k, shared, grid, s.begin);
      solve(s, *workers_[k], grid, request, state, own);
      own.hand_on();
      s.handed_on = own.handed_on();
    } catch (...) {  // an exception must not leave its thread
      s.error = std::current_exception();
    }
  }
  Summary whole;
  for (int k = 0; k < count; ++k) {
    const Segment& s = all[k];
    if (s.error) std::rethrow_exception(s.error);
    const bool meets = k + 1 == count || (s.ended && all[k + 1].total &&
                                          segments_meet(workers_[k]->model(), workers_[k]->q(),
                                                        all[k + 1].first_position));
    if (!shared.stopped && !(s.total && meets)) return {};
    whole.instants += s.handed_on.instants;
    whole.updates += s.handed_on.updates;
    if (!s.total) continue;
    whole.iterations += s.total->iterations;
    whole.sub_steps += s.total->sub_steps;
    whole.residual = std::max(whole.residual, s.total->residual);
  }
  whole.time = grid.time(grid.instants - 1);
  whole.stopped = shared.stopped;
  if (!whole.stopped) state = workers_[count - 1]->state();
  return whole;
}

void SegmentsOnThreads::solve(Segment& s, TimeStepping& worker, const TimeGrid& grid,
                              const Request& request, const State& first, Observer& observer) {
  if (!worker.start_at(first.q, grid.time(s.begin))) return;
  s.first_position.assign(worker.q().begin(), worker.q().end());
  s.total = worker.run_on(cut(grid, s.begin, s.end), request, observer);
  if (s.total && !s.total->stopped && s.end < grid.instants)
    s.ended = worker.step(grid.time(s.end), Level::position).ok();
}

}  // namespace desmo
