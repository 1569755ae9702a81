// Segments of a motion solved at once: the same instants as step by step, or step by step after
// all.

#include "formulations/batch/segments_in_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/base/output_writer.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/motion/internals.h"
#include "formulations/variants.h"
#include "tests/borrowed_part.h"
#include "tests/everything.h"
#include "tests/lanes_here.h"
#include "tests/lender.h"
#include "tests/mechanisms.h"

namespace desmo::segments_in_lanes_test {
namespace {

std::vector<Settings> every_kind() {
  std::vector<Settings> all;
  for (const int lanes : lanes_here())
    for (const Guess guess : {Guess::previous, Guess::hermite5, Guess::adams8})
      all.push_back({.guess = guess, .segments = lanes});
  return all;
}

TEST(SegmentsInLanes, SolveWhatStepsSolve) {
  const auto all = every_motion();
  for (const char* id : {"group_symbolic_explicit", "block_symbolic_explicit"})
    for (const Settings& settings : every_kind())
      for (const auto& [m, grid] : all) {
        const auto by_steps = formulated(id, m), lanes = formulated(id, m, settings);
        const Everything actual = expect_same_motion(*lanes, *by_steps, grid, m.name);
        EXPECT_TRUE(std::ranges::is_sorted(actual.order)) << m.name;
      }
}

/// Runs that ask for a part of the coordinates have the right values there.
class OnTheCases : public testing::TestWithParam<Settings> {};

TEST_P(OnTheCases, SegmentsNeedNoSteps) {
  for (const Case& c : cases()) {
    const Model m = make_model(c.with_units(2));
    const auto f = formulated("group_symbolic_explicit", m, GetParam()),
               g = formulated("group_symbolic_explicit", m);
    const TimeGrid grid = time_grid(3, 0.01);
    const Everything whole = expect_same_motion(*f, *g, grid, std::string(c.name));
    EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0) << c.name;
    EXPECT_EQ(whole.order.size(), static_cast<std::size_t>(grid.instants));
    EXPECT_TRUE(std::ranges::is_sorted(whole.order));

    const std::vector<int> asked{1, m.coordinates() - 1};
    Everything some(grid.instants);
    ASSERT_TRUE(f->run(grid, {Level::velocity, asked}, some).ok());
    for (int i = 0; i < grid.instants; ++i)
      for (const int k : {1, m.coordinates() - 1, m.coordinates() + 1})
        EXPECT_EQ(some.all[i][k], whole.all[i][k]) << i;
  }
}

/// Memory is borrowed for as many instants at once as may be, up to the end of the segments.
/// Eleven coordinates are taken out of lanes as eight or twice four, two and one.
TEST_P(OnTheCases, OutputsHoldWhatIsRequested) {
  const Model m = truck_model(2);
  const auto f = formulated("group_symbolic_explicit", m, GetParam());
  const TimeGrid grid = time_grid(3, 0.01);  // the last segment is shorter
  const int lanes = GetParam().segments, length = (grid.instants + lanes - 1) / lanes;
  const Everything whole = everything_of(*f, grid);
  for (const Level level : all_levels)
    for (const std::vector<int>& some :
         {std::vector{7}, std::vector{m.coordinates() - 1, 3, 4, 5, 20, 2, 50, 51, 100, 99, 8}})
      for (const int steps : {1, 3, length, 2 * length}) {
        Lender lender(grid.instants, some, level, lanes * steps);
        const Summary s = f->run(grid, {Level::acceleration, some}, lender);
        ASSERT_TRUE(s.ok());
        EXPECT_EQ(s.updates, lender.updates);  // lanes past the end do not count
        expect_in_outputs(lender, some, level, whole.all);
        EXPECT_EQ(lender.asked, (length + steps - 1) / steps);
      }
}

TEST_P(OnTheCases, SegmentsStopWhereTheObserverStops) {
  const Model m = truck_model(1);
  const TimeGrid grid = time_grid(3, 0.01);
  const auto f = formulated("group_symbolic_explicit", m, GetParam());
  Lender lender(grid.instants, {7}, Level::position);
  lender.stop_at = 20;  // in the first segment, the first of its step
  const Summary stopped = f->run(grid, {.coordinates = std::vector{7}}, lender);
  EXPECT_TRUE(stopped.ok() && stopped.stopped);
  EXPECT_EQ(stopped.instants, 20L * GetParam().segments + 1);
  EXPECT_EQ(lender.instants, stopped.instants);
  EXPECT_GT(stopped.residual, 0);
  EXPECT_LE(stopped.residual, f->tolerance());
  EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0);
}

/// An observer in order of time stops after twenty instants, when all are solved.
TEST(Segments, CountWhatTheObserverTook) {
  struct Stopping final : Observer {
    Flow observe(const Instant& instant) noexcept override {
      updates += instant.updates;
      return ++instants == 20 ? Flow::stop : Flow::go_on;
    }
    long instants = 0, updates = 0;
  } observer;
  const Model m = truck_model(1);
  const auto f = formulated("group_symbolic_explicit/segments:4", m);
  const Summary s = f->run(time_grid(3, 0.01), {}, observer);
  EXPECT_TRUE(s.ok() && s.stopped);
  EXPECT_EQ(s.instants, 20);
  EXPECT_GT(s.updates, 0);
  EXPECT_EQ(s.updates, observer.updates);
}

INSTANTIATE_TEST_SUITE_P(SegmentsInLanes, OnTheCases, testing::ValuesIn(every_kind()));

TEST(SegmentsInLanes, LeaveShortMotionsToSteps) {
  const Model m = truck_model(1);
  const auto f = formulated("group_symbolic_explicit/segments:4", m);
  const TimeGrid grid = time_grid(0.2, 0.01);
  EXPECT_EQ(everything_of(*f, grid).order.size(), static_cast<std::size_t>(grid.instants));
  EXPECT_TRUE(everything_of(*f, TimeGrid{}).order.empty());  // nothing was to be solved
  EXPECT_EQ(stepping_of(*f).runs_without_segments(), 1);
}

/// The errors that a tolerance of 1e-7 leaves are no other branch. A way of 1e-5 to another branch
/// is short, but no rounding.
TEST(Segments, MeetWithinAMillionthOfTheirSize) {
  const Model m = four_bar_model(1);
  const int angle = m.entities[m.find("dyad1/psi")].first, x = m.entities[m.find("dyad1/C")].first;
  double length = 0;
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && e.kind != EntityKind::angle && i < e.first + e.size; ++i)
      length = std::max(length, std::abs(m.estimate[i]));
  for (const double share : {0.3, 3.}) {
    for (const auto& [i, size] : {std::pair(angle, 1.), std::pair(x, length)}) {
      std::vector<double> ended = m.estimate;
      ended[i] += share * 1e-6 * size;
      EXPECT_EQ(segments_meet(m, ended, m.estimate), share < 1) << share;
    }
  }
}

/// A part that compares the last positions of a step, those of all coordinates, with where it was.
class Remembering final : public Borrowed {
 public:
  Remembering(Part& part, int& steps) : Borrowed(part), steps_(steps) {}
  PartResult solve(State& s, std::span<const double> last, Level level) override {
    if (level == Level::acceleration) {
      EXPECT_TRUE(std::ranges::equal(last, now_));
      ++steps_;
    }
    const PartResult result = Borrowed::solve(s, last, level);
    now_ = s.q;
    return result;
  }

 private:
  int& steps_;
  std::vector<double> now_;
};

TEST(SegmentsInLanes, TellPartsAllPositionsOfTheInstantBefore) {
  const Model m = four_bar_model(2);
  const auto f = formulated("global_automatic_eigen", m);
  std::vector<std::unique_ptr<Formulation>> solvers;
  std::vector<SegmentsInLanes::Parts> lanes(4);
  int steps = 0;
  for (SegmentsInLanes::Parts& parts : lanes) {
    solvers.push_back(formulated("global_automatic_eigen", m));
    for (const DefinedPart& p : parts_of(*solvers.back()))
      parts.push_back({p.definition, std::make_unique<Remembering>(*p.solver, steps)});
  }
  SegmentsInLanes motion(m, std::move(lanes), Settings{}, KernelTable::built_in());
  ASSERT_TRUE(f->assemble(0).ok());
  State state = stepping_of(*f).state();
  const TimeGrid grid = time_grid(1, 0.01);
  Lender lender(grid.instants, {7}, Level::position);
  static_cast<void>(motion.run(grid, {.coordinates = std::vector{7}}, state, lender));
  EXPECT_GT(steps, 8);
}

/// Runs that are never what they should be.
class Reluctant final : public SegmentExecutor {
 public:
  std::optional<Summary> run(const TimeGrid&, const Request& request, State& state,
                             Observer& observer) override {
    std::ranges::fill(state.q, 17.0);
    OutputWriter(request, 8).hand_over({3, 17.0, std::span(state.q).first(8), {}, {}}, observer);
    return {};
  }
};

TEST(SegmentsInLanes, ThatGiveUpLeaveNoTrace) {
  const Model m = four_bar_model(2);
  auto parts = make_partition(m, Partition::group);
  const auto g = formulated("group_automatic_eigen", m);
  std::vector<DefinedPart> borrowed;
  for (const auto& p : parts_of(*g))
    borrowed.push_back({p.definition, std::make_unique<Borrowed>(*p.solver)});
  TimeStepping f(m, std::move(borrowed), Settings{}, std::make_unique<Reluctant>());
  const TimeGrid grid = time_grid(1, 0.01);
  expect_same_motion(f, *g, grid, "reluctant");
  Lender lender(grid.instants, {7}, Level::position);
  ASSERT_TRUE(f.run(grid, {.coordinates = std::vector{7}}, lender).ok());
  EXPECT_EQ(lender.restarts, 1);
  EXPECT_EQ(lender.instants, grid.instants + 1);
  EXPECT_EQ(f.runs_without_segments(), 2);
}

}  // namespace
}  // namespace desmo::segments_in_lanes_test
