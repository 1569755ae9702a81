// What goes wrong where a limit of find_range() is ten times smaller or larger than it is.

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "cases/io/files.h"
#include "cases/mechanism/builder.h"
#include "formulations/verification/range/driver_range.h"
#include "tests/mechanisms.h"
#include "tests/range/four_bar.h"
#include "tests/range/solved_start.h"

namespace desmo::range_limit_test {
namespace {

using range_test::four_bar, range_test::Links;

constexpr double pi = std::numbers::pi;

/// Finds the range of a model's driver with one limit multiplied by a factor.
template <class T>
DriverRange range_of(const Model& m, T RangeLimits::*limit, double factor, int driver = 0) {
  RangeLimits limits;
  limits.*limit = static_cast<T>(limits.*limit * factor);
  return find_range(m, solved_start(m), driver, limits);
}

/// Returns the seconds of this thread's processor that a call takes.
template <class Call>
double seconds(Call&& call) {
  const std::clock_t start = std::clock();
  call();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A crank and a wheel that it turns so many times as fast.
Model geared_wheel(double ratio) {
  MechanismBuilder builder("geared_wheel", 2);
  add(builder, {.crank = 1, .start = 0.5, .dyads = {}});
  const int o = builder.point("W", {3, 0, 0}), rim = builder.point("R", {4, 0, 0});
  builder.carry(MechanismBuilder::ground, {o});
  const int wheel = builder.body("wheel", {o, rim});
  builder.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, wheel, {o});
  builder.angle("turned", {-1, o, rim});
  builder.couple("mesh", {{0, -ratio}, {1, 1}});
  return model_mechanism(builder.release(), {Polynomial{{0.5}}}).model;
}

/// A start at 3e-10 or 3e-9 rad from a dead point is on it, or next to it.
TEST(RangeLimits, AccuracyTellsWhetherAStartIsADeadPoint) {
  const Links links{4, 3, 3.5, 8};
  const auto is_dead_point = [&](double before, double factor) {
    const Model m = four_bar(links, links.angle_at(6.5) - before);
    return range_of(m, &RangeLimits::accuracy, factor).other_branch.has_value();
  };
  EXPECT_TRUE(is_dead_point(3e-10, 1));
  EXPECT_FALSE(is_dead_point(3e-10, 0.1));
  EXPECT_FALSE(is_dead_point(3e-9, 1));
  EXPECT_TRUE(is_dead_point(3e-9, 10));
}

TEST(RangeLimits, LongerStepsMissALockAndShorterOnesCostMore) {
  Model delta =
      make_model(read_scene(DESMO_SOURCE_DIR "/tests/range/scenes/delta_platform_driven.json"));
  const double lower = -std::sqrt(0.9 * 0.9 - 0.15 * 0.15),
               upper = -std::sqrt(0.3 * 0.3 - 0.15 * 0.15);
  const auto is_right = [&](double factor) {
    bool all = true;
    for (const double before : {1e-6, 1e-11}) {
      delta.drivers[2].motion = Polynomial{{lower + before}};
      const DriverRange r = range_of(delta, &RangeLimits::max_step, factor, 2);
      all = all && r.down.stop == RangeStop::dead_point && !r.other_branch &&
            std::abs(r.down.value - lower) < 1e-12 && std::abs(r.up.value - upper) < 1e-12;
    }
    return all;
  };
  EXPECT_TRUE(is_right(1));
  EXPECT_FALSE(is_right(10));
  const Model crank = four_bar({2, 6, 5, 7}, 1);
  const auto cost = [&](double factor) {
    return seconds([&] { range_of(crank, &RangeLimits::max_step, factor); });
  };
  EXPECT_GT(cost(0.1), 4 * cost(1));
}

/// Returns how many starts of a drag link lead to two turns, after which it is back.
int right_turns(double RangeLimits::*limit, double factor) {
  int right = 0;
  for (int degrees = 9; degrees < 360; degrees += 3) {
    const Model m = four_bar({0.4, 1.1, 0.5, 1}, degrees * pi / 180);
    const DriverRange r = range_of(m, limit, factor);
    right += r.up.stop == RangeStop::full_turn && r.up.turns == 2;
  }
  return right;
}

TEST(RangeLimits, LargerCorrectionsChangeTheBranchAndSmallerOnesCostMore) {
  int right = 0;
  const double cost = seconds([&] { right = right_turns(&RangeLimits::max_correction, 1); });
  EXPECT_EQ(right, 117);
  const auto right_deltoids = [](double factor) {
    int count = 0;
    for (const int side : {1, -1})
      for (double degrees = 9; degrees < 352; degrees += 1.7)
        count += range_of(four_bar({1, 2, 2, 1}, degrees * pi / 180, side),
                          &RangeLimits::max_correction, factor)
                     .up.turns == 2;
    return count;
  };
  EXPECT_GT(right_deltoids(1), right_deltoids(10));
  EXPECT_GT(seconds([&] { right_turns(&RangeLimits::max_correction, 0.1); }), 2 * cost);
}

/// Rounding opens a crossing; shorter links by 1e-12 do, too, by 1e-6: a dead point.
TEST(RangeLimits, AWiderCrossingPassesAGapAndANarrowerOneIsNotPassed) {
  EXPECT_EQ(right_turns(&RangeLimits::max_crossing_step, 1), 117);
  EXPECT_LT(right_turns(&RangeLimits::max_crossing_step, 0.1), 117);
  const auto stop = [](double factor) {
    const Model m = four_bar({1, 2 - 1e-11, 1, 2}, 1);
    return range_of(m, &RangeLimits::max_crossing_step, factor).up.stop;
  };
  EXPECT_EQ(stop(1), RangeStop::dead_point);
  EXPECT_NE(stop(10), RangeStop::dead_point);
}

TEST(RangeLimits, AnEndlessDriveCostsAsManyStepsAsAreAllowed) {
  const Model fast = geared_wheel(200), endless = geared_wheel(1e9);
  EXPECT_EQ(range_of(fast, &RangeLimits::max_steps, 1).up.stop, RangeStop::full_turn);
  EXPECT_EQ(range_of(fast, &RangeLimits::max_steps, 0.1).up.stop, RangeStop::not_reached);
  const auto cost = [&](double factor) {
    return seconds([&] { range_of(endless, &RangeLimits::max_steps, factor); });
  };
  EXPECT_GT(cost(0.1), 4 * cost(0.01));
}

}  // namespace
}  // namespace desmo::range_limit_test
