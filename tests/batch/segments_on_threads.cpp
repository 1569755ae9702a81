// Segments of a motion on several threads: the same instants as step by step, or step by step
// after all; and what holds of segments in lanes, too.

#include "formulations/batch/segments_on_threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/algebra/blas.h"
#include "formulations/motion/internals.h"
#include "tests/borrowed_part.h"
#include "tests/dead_point.h"
#include "tests/every_variant.h"
#include "tests/everything.h"
#include "tests/lender.h"
#include "tests/mechanisms.h"

namespace desmo::segments_on_threads_test {
namespace {

int moving_unknowns(const Formulation& f) {
  std::size_t sum = 0;
  for (const DefinedPart& p : parts_of(f))
    if (!p.definition.constant) sum += p.definition.unknowns.size();
  return static_cast<int>(sum);
}

/// The motion of the grid in so short steps that each of three threads has something to do.
TimeGrid worth_three_threads(const TimeGrid& grid, const Formulation& f) {
  const int instants = std::max(grid.instants, 330'000 / moving_unknowns(f));
  return {grid.start, grid.step * (grid.instants - 1) / (instants - 1), instants};
}

/// Solves with and without threads, and compares.
void compare(const Model& m, const TimeGrid& of_scene, const std::string& id, int threads) {
  const std::string parallel_id = id + "/threads:" + std::to_string(threads);
  const auto serial = formulated(id, m), parallel = formulated(parallel_id, m);
  const TimeGrid grid = worth_three_threads(of_scene, *serial);
  expect_same_motion(*parallel, *serial, grid, m.name + " " + parallel_id);
}

TEST(SegmentsOnThreads, SolvesWhatOneThreadSolves) {
  for (const auto& [m, grid] : every_motion()) {
    compare(m, grid, "group_symbolic_explicit/guess:hermite5", 3);
    compare(m, grid, "group_symbolic_explicit/segments:4", 2);
  }
}

TEST(SegmentsOnThreads, GoesWithEveryAlgebra) {
  set_blas_threads(1);  // more wait for each other where matrices are this small
  const Model m = truck_model(1);
  for (const Variant& v : tested_variants())
    if (v.partition == Partition::group &&
        (v.evaluation == Evaluation::automatic || v.is_generated()))
      compare(m, time_grid(1, 0.01), v.id, 2);
}

TEST(SegmentsOnThreads, IsSolvedByAsManyThreadsAsAskedFor) {
  for (const Case& c : cases())
    for (const char* id : {"group_symbolic_explicit/threads:3", "group_automatic_klu/threads:3",
                           "group_symbolic_explicit/lanes:4/threads:3",
                           "group_symbolic_explicit/segments:4/threads:3"}) {
      const Model m = make_model(c.with_units(2));
      const auto f = formulated(id, m);
      const TimeGrid grid = worth_three_threads(time_grid(3, 0.01), *f);
      Lender lender(grid.instants, {1}, Level::position);
      ASSERT_TRUE(f->run(grid, {.coordinates = std::vector{1}}, lender).ok());
      EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0) << c.name << " " << id;
      EXPECT_EQ(lender.threads.size(), 3u) << c.name << " " << id;
      EXPECT_EQ(lender.instants, grid.instants) << c.name << " " << id;
    }
}

/// Results are the same to the last bit whichever thread is first. They come in order of time for
/// an observer that needs it.
TEST(SegmentsOnThreads, DoesNotDependOnWhoIsFirst) {
  const Model m = truck_model(2);
  const auto f = formulated("group_symbolic_explicit/guess:hermite5/threads:3", m);
  const TimeGrid grid = worth_three_threads(time_grid(3, 0.01), *f);
  Everything first(grid.instants), again(grid.instants);
  const Summary a = f->run(grid, {}, first), b = f->run(grid, {}, again);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(first.all, again.all);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.updates, b.updates);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_TRUE(std::ranges::is_sorted(again.order));
}

TEST(SegmentsOnThreads, StaysOnOneThreadWhereThereIsLittleToDo) {
  const Model m = four_bar_model(1);
  const auto f = formulated("group_symbolic_explicit/threads:3", m);
  const TimeGrid grid = time_grid(3, 0.01);
  Lender lender(grid.instants, {1}, Level::position);
  ASSERT_TRUE(f->run(grid, {.coordinates = std::vector{1}}, lender).ok());
  EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0);
  EXPECT_EQ(lender.threads, std::set{std::this_thread::get_id()});
}

TEST(Segments, LeaveTheLastInstantToStepOnFrom) {
  const Model m = truck_model(2);
  for (const char* id : {"group_symbolic_explicit/segments:4", "group_symbolic_explicit/threads:2",
                         "group_symbolic_explicit/lanes:4/threads:3"}) {
    const auto f = formulated(id, m), g = formulated("group_symbolic_explicit", m);
    const TimeGrid grid = worth_three_threads(time_grid(2, 0.01), *f);
    everything_of(*f, grid);
    ASSERT_TRUE(g->assemble(2).ok());
    expect_to_step_on_alike(*f, *g, 2);
  }
}

/// Only what is asked for is solved on threads, too.
TEST(SegmentsOnThreads, LeavesOutWhatNobodyAsksFor) {
  const Model m = truck_model(2);
  const auto f = formulated("group_symbolic_explicit/threads:2", m);
  f->solve_only(std::vector(m.coordinates(), Level::position));
  everything_of(*f, worth_three_threads(time_grid(2, 0.01), *f));
  for (const DefinedPart& part : parts_of(*f))
    for (const int k : part.definition.unknowns) EXPECT_EQ(f->qdd()[k], 0) << k;
}

TEST(Segments, FailAsStepsFail) {
  const Model m = locking_four_bar();
  for (const char* id :
       {"group_symbolic_explicit/segments:4", "group_symbolic_explicit/threads:3"}) {
    const auto f = formulated(id, m), g = formulated("group_symbolic_explicit", m);
    expect_to_fail_alike(*f, *g, worth_three_threads(time_grid(6, 0.01), *g));
    EXPECT_EQ(stepping_of(*f).runs_without_segments(), 1) << id;
  }
}

using Worker = std::unique_ptr<TimeStepping>;

Worker worker(const Model& m) {
  return Worker(&stepping_of(*formulated("group_automatic_eigen", m).release()));
}

/// A worker with parts of another kind, which forward to those of f.
template <class Kind>
Worker worker_with(Formulation& f) {
  std::vector<DefinedPart> parts;
  for (const DefinedPart& p : parts_of(f))
    parts.push_back({p.definition, std::make_unique<Kind>(*p.solver)});
  return std::make_unique<TimeStepping>(f.model(), std::move(parts), Settings{});
}

/// Solves a motion by these workers, one segment each.
template <class... Workers>
std::optional<Summary> solved_by(const TimeGrid& grid, const Model& m, Workers... each) {
  std::vector<Worker> workers;
  (workers.push_back(std::move(each)), ...);
  SegmentsOnThreads motion(std::move(workers), 16);
  EXPECT_EQ(motion.segments(grid.instants), static_cast<int>(sizeof...(each)));
  const Worker first = worker(m);
  EXPECT_TRUE(first->assemble(0, Level::acceleration).ok());
  State state = first->state();
  Lender lender(grid.instants, {1}, Level::position);
  return motion.run(grid, {.coordinates = std::vector{1}}, state, lender);
}

TEST(SegmentsOnThreads, IsGivenUpWhereSegmentsDoNotMeet) {
  const Model m = truck_model(1);
  Model other = m;
  for (Constraint& c : other.constraints)
    for (Derived& constant : c.constants) constant = constant * (1 + 1e-5);
  const TimeGrid grid = worth_three_threads(time_grid(1, 0.01), *worker(m));
  EXPECT_FALSE(solved_by(grid, m, worker(m), worker(other)));
}

/// A part that solves no positions alone, as a continuation asks for.
struct Blocked final : Borrowed {
  using Borrowed::Borrowed;
  PartResult solve(State& s, std::span<const double> last, Level level) override {
    if (level == Level::position) return {.status = Status::not_converged};
    return Borrowed::solve(s, last, level);
  }
};

TEST(SegmentsOnThreads, IsGivenUpWhereASegmentIsNotReached) {
  const Model m = truck_model(1);
  const auto f = formulated("group_automatic_eigen", m);
  const TimeGrid grid = worth_three_threads(time_grid(1, 0.01), *f);
  EXPECT_FALSE(solved_by(grid, m, worker(m), worker_with<Blocked>(*f)));
}

/// A part that does not solve its tenth step.
struct Refusing final : Borrowed {
  using Borrowed::Borrowed;
  PartResult solve(State& s, std::span<const double> last, Level level) override {
    if (level == Level::acceleration && ++steps == 10) return {.status = Status::not_converged};
    return Borrowed::solve(s, last, level);
  }
  int steps = 0;
};

TEST(SegmentsOnThreads, CountsSubSteps) {
  const Model m = four_bar_model(1);
  const auto f = formulated("global_automatic_eigen", m);
  const auto total = solved_by(time_grid(0.2, 0.01), m, worker_with<Refusing>(*f));
  ASSERT_TRUE(total);
  EXPECT_EQ(total->sub_steps, 2);
}

TEST(SegmentsOnThreads, StopsWhereTheObserverStops) {
  const Model m = truck_model(2);
  const auto f = formulated("group_symbolic_explicit/threads:2", m);
  const TimeGrid grid = worth_three_threads(time_grid(1, 0.01), *f);
  Lender lender(grid.instants, {1}, Level::position);
  lender.stop_at = 300;
  const Summary stopped = f->run(grid, {.coordinates = std::vector{1}}, lender);
  EXPECT_TRUE(stopped.ok() && stopped.stopped);
  EXPECT_LT(lender.instants, grid.instants);
  EXPECT_EQ(stopped.instants, lender.instants);
  EXPECT_EQ(stopped.updates, lender.updates);
  EXPECT_EQ(lender.restarts, 0);
  Everything observer(grid.instants);
  EXPECT_FALSE(f->run(grid, {}, observer).stopped);
  EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0);
}

/// Each thread has an observer of its own.
TEST(SegmentsOnThreads, NeedsNoLockWhereEveryThreadHasAnObserver) {
  const Model m = truck_model(2);
  const auto f = formulated("group_symbolic_explicit/threads:2", m);
  const TimeGrid grid = worth_three_threads(time_grid(1, 0.01), *f);
  struct Split final : Lender {
    using Lender::Lender;
    Observer* of_thread(int thread) noexcept override { return &own[thread]; }
    std::vector<Lender> own;
  } split(0, {}, Level::position);
  split.own.assign(2, Lender(grid.instants, {1}, Level::velocity));
  ASSERT_TRUE(f->run(grid, {.coordinates = std::vector{1}}, split).ok());
  EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0);
  EXPECT_EQ(split.instants, 0);
  EXPECT_EQ(split.own[0].instants + split.own[1].instants, grid.instants);
  for (const Lender& own : split.own) EXPECT_EQ(own.threads.size(), 1u);
}

}  // namespace
}  // namespace desmo::segments_on_threads_test
