// Memory that observers lend, and parts that keep what they find until it is asked for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>
#include <vector>

#include "formulations/base/output_writer.h"
#include "tests/everything.h"
#include "tests/lanes_here.h"
#include "tests/lender.h"
#include "tests/mechanisms.h"

namespace desmo::outputs_test {
namespace {

/// Five axles: a batch with lanes that are left empty, or one full and an axle left over.
const Model& truck() {
  static const Model m = truck_model(5);
  return m;
}

const TimeGrid grid{0, 0.01, 60};

std::vector<int> all_of(const Model& m) { return requested_coordinates({}, m.coordinates()); }

/// Some of every axle and what none of them has, as they come; all of one axle; all.
std::vector<std::vector<int>> selections(const Model& m) {
  const std::vector<int> all = all_of(m);
  std::vector<int> scattered;
  for (int i = m.coordinates() - 1; i >= 0; i -= 7) scattered.push_back(i);
  return {scattered, {all.begin() + 120, all.begin() + 200}, {0}, all};
}

class OnLanes : public testing::TestWithParam<int> {
 protected:
  std::unique_ptr<Formulation> make(Guess guess = Guess::adams8) const {
    return formulated("group_symbolic_explicit", truck(), {.guess = guess, .lanes = GetParam()});
  }
};

TEST_P(OnLanes, OutputsHoldWhatObserversAreShown) {
  for (const Guess guess : {Guess::previous, Guess::hermite5, Guess::adams8}) {
    const auto f = make(guess), g = make(guess);
    const Everything whole = everything_of(*g, grid);
    for (const Level level : all_levels)
      for (const std::vector<int>& some : selections(truck())) {
        Lender lender(grid.instants, some, level);
        ASSERT_TRUE(f->run(grid, {Level::acceleration, some}, lender).ok());
        expect_in_outputs(lender, some, level, whole.all);
      }
  }
}

/// The axles that they drive are left out.
TEST_P(OnLanes, OutputsHoldDriversAtEveryLevel) {
  const auto f = make(), g = make();
  std::vector<int> drivers;
  for (const Driver& d : truck().drivers) drivers.push_back(truck().entities[d.coordinate].first);
  f->solve_only(std::vector<Level>(truck().coordinates(), Level::position));
  const Everything whole = everything_of(*g, grid);
  Lender lender(grid.instants, drivers, Level::acceleration);
  ASSERT_TRUE(f->run(grid, {Level::acceleration, drivers}, lender).ok());
  expect_in_outputs(lender, drivers, Level::acceleration, whole.all);
}

/// The observer lends memory, or none.
TEST_P(OnLanes, NothingIsMissingBehindARunThatWasAskedForLittle) {
  const int n = truck().coordinates();
  const std::vector<int> asked{n - 1, 40, 151};
  Lender lender(grid.instants, asked, Level::position);
  Everything shown(grid.instants);
  for (Observer* const observer : std::initializer_list<Observer*>{&lender, &shown}) {
    const auto f = make(), g = make();
    const Everything whole = everything_of(*g, grid);
    ASSERT_TRUE(f->run(grid, {Level::acceleration, asked}, *observer).ok());
    EXPECT_TRUE(are_at_one_instant(*f, *g));
    for (int i = 0; i < 3; ++i) {
      const double t = grid.time(grid.instants + i);
      ASSERT_TRUE(f->step(t).ok() && g->step(t).ok());
      EXPECT_TRUE(are_at_one_instant(*f, *g));
    }
    for (const int i : asked)
      for (const int k : {i, n + i, 2 * n + i})
        if (observer == &shown) EXPECT_EQ(shown.all.back()[k], whole.all.back()[k]) << k;
  }
}

/// An axle is driven out of its reach.
TEST_P(OnLanes, PositionsAreAsTheyWereBehindARunThatFails) {
  Model m = truck();
  const int last = 20;
  std::get<HarmonicSum>(m.drivers[2].motion).terms.push_back({0.2, 1.0, -grid.time(last)});
  const TimeGrid far{0, 0.1, 60};
  const auto with = [&](int lanes) {
    return formulated("group_symbolic_explicit/guess:adams8", m, {.lanes = lanes});
  };
  const auto f = with(GetParam()), g = with(GetParam()), one_by_one = with(1);
  Everything whole(far.instants);
  Lender lender(far.instants, {7}, Level::position);
  const Summary expected = g->run(far, {}, whole);
  const Summary failed = f->run(far, {Level::acceleration, std::vector{7}}, lender);
  ASSERT_FALSE(expected.ok());
  ASSERT_GT(expected.instants, 5);
  EXPECT_EQ(failed.instants, expected.instants);
  EXPECT_EQ(describe(failed, m), describe(expected, m));
  EXPECT_TRUE(std::ranges::equal(f->q(), g->q()));
  ASSERT_FALSE(one_by_one->run(far, {}, whole).ok());
  for (int i = 0; i < m.coordinates(); ++i) EXPECT_NEAR(f->q()[i], one_by_one->q()[i], 1e-10) << i;
  const double back = far.time(static_cast<int>(failed.instants) - 2);
  ASSERT_TRUE(f->step(back).ok() && one_by_one->step(back).ok());
  for (int i = 0; i < m.coordinates(); ++i)
    EXPECT_NEAR(f->qdd()[i], one_by_one->qdd()[i], 1e-7) << i;
}

TEST_P(OnLanes, RequestsNameEveryCoordinateOnceOrAreRefused) {
  for (const std::vector<int>& wrong :
       {std::vector{7, 8, 7}, {truck().coordinates()}, std::vector{3, -1}}) {
    const auto f = make();
    Lender lender(grid.instants, wrong, Level::position);
    for (int i = 0; i < 2; ++i)
      EXPECT_THROW(static_cast<void>(f->run(grid, {.coordinates = wrong}, lender)),
                   std::invalid_argument);
  }
}

INSTANTIATE_TEST_SUITE_P(Outputs, OnLanes, testing::ValuesIn(lanes_here()));

/// Steps go on from where the observer stopped the run.
TEST_P(OnLanes, NothingIsMissingWhereAnObserverStops) {
  const auto f = make(), g = make();
  Lender lender(grid.instants, {7}, Level::position), until(21, all_of(truck()), Level::position);
  lender.stop_at = 20;
  const Summary stopped = f->run(grid, {Level::acceleration, std::vector{7}}, lender);
  ASSERT_TRUE(stopped.ok() && g->run({0, 0.01, 21}, {}, until).ok());
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.instants, 21);
  EXPECT_EQ(lender.instants, 21);
  EXPECT_TRUE(std::ranges::equal(f->qdd(), g->qdd()));
  ASSERT_TRUE(f->step(0.21).ok() && g->step(0.21).ok());
  EXPECT_TRUE(std::ranges::equal(f->qdd(), g->qdd()));
}

TEST(Outputs, OfAPoolAreTakenAgain) {
  OutputPool pool(5, Level::velocity);
  const OutputView a = pool.take(), b = pool.take();
  for (const OutputView& output : {a, b}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(output.q) % 64, 0u);
    EXPECT_GE(std::abs(output.qd - output.q), 5);
    EXPECT_EQ(output.qdd, nullptr);
  }
  EXPECT_GE(std::abs(a.q - b.q), 10);
  a.q[4] = 1;
  pool.give_back(a);
  const OutputView again = pool.take();
  EXPECT_EQ(again.q, a.q);
  EXPECT_EQ(again.q[4], 1);
  EXPECT_NE(pool.take().q, b.q);
}

}  // namespace
}  // namespace desmo::outputs_test
