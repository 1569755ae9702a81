// What goes wrong where a limit of find_range() is ten times smaller or larger than it is.

#include <gtest/gtest.h>

#include "cases/mechanism/builder.h"
#include "tests/mechanisms.h"
#include "tests/range/four_bar.h"
#include "tests/range/solved_start.h"

namespace desmo::range_limit_test {
namespace {

using range_test::four_bar, range_test::Links;

/// Finds the range of a model's driver with one limit multiplied by a factor.
template <class T>
DriverRange range_of(const Model& m, T RangeLimits::*limit, double factor, int driver = 0) {
  RangeLimits limits;
  limits.*limit = static_cast<T>(limits.*limit * factor);
  return desmo::range_of(m, driver, limits);
}

/// Returns whether a crank turns fully within a number of steps, tried with one limit multiplied.
bool turns_in(int steps, const Model& m, double RangeLimits::*limit, double factor) {
  RangeLimits limits{.max_steps = steps};
  limits.*limit *= factor;
  return desmo::range_of(m, 0, limits).up.stop == RangeStop::full_turn;
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

/// A delta robot passes two singular positions 0.022 rad apart.
TEST(RangeLimits, LongerStepsMissChangePointsAndShorterOnesCostMore) {
  const Model delta = make_model(library_scene("delta"));
  const auto points = [&](double factor) {
    return range_of(delta, &RangeLimits::max_step, factor, 1).change_points.size();
  };
  EXPECT_EQ(points(1), 2u);
  EXPECT_EQ(points(10), 0u);
  const Model crank = four_bar({2, 6, 5, 7}, 1);
  EXPECT_TRUE(turns_in(100, crank, &RangeLimits::max_step, 1));
  EXPECT_FALSE(turns_in(500, crank, &RangeLimits::max_step, 0.1));
}

TEST(RangeLimits, SmallerCorrectionsCostMore) {
  const Model crank = four_bar({2, 6, 5, 7}, 1);
  EXPECT_TRUE(turns_in(100, crank, &RangeLimits::max_correction, 1));
  EXPECT_FALSE(turns_in(200, crank, &RangeLimits::max_correction, 0.1));
}

/// Links shorter by 1e-14 open a gap as rounding may; by 1e-12, one with dead points.
TEST(RangeLimits, AWiderCrossingPassesAGapAndANarrowerOneIsNotPassed) {
  const auto stop = [](double shorter, double factor) {
    const Model m = four_bar({1, 2 - shorter, 1, 2}, 1);
    return range_of(m, &RangeLimits::max_crossing_step, factor).up.stop;
  };
  EXPECT_EQ(stop(1e-14, 1), RangeStop::full_turn);
  EXPECT_NE(stop(1e-14, 0.1), RangeStop::full_turn);
  EXPECT_EQ(stop(1e-12, 1), RangeStop::dead_point);
  EXPECT_NE(stop(1e-12, 10), RangeStop::dead_point);
}

TEST(RangeLimits, AnEndlessDriveEndsAfterAsManyStepsAsAreAllowed) {
  const Model fast = geared_wheel(200);
  EXPECT_EQ(range_of(fast, &RangeLimits::max_steps, 1).up.stop, RangeStop::full_turn);
  EXPECT_EQ(range_of(fast, &RangeLimits::max_steps, 0.1).up.stop, RangeStop::not_reached);
  const double ratio = 1e9;
  const Model endless = geared_wheel(ratio);
  const auto steps = [&](double factor) {
    const DriverRange r = range_of(endless, &RangeLimits::max_steps, factor);
    return (r.up.value - r.start) * ratio / RangeLimits{}.max_step;
  };
  EXPECT_GT(steps(0.01), 9 * steps(0.001));
}

}  // namespace
}  // namespace desmo::range_limit_test
