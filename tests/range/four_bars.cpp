// Ranges of four-bars whose limits, change points and turns have closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>

#include "cases/extremes/rows.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"
#include "tests/range/four_bar.h"
#include "tests/range/solved_start.h"

namespace desmo::four_bar_range_test {
namespace {

using range_test::four_bar, range_test::Links;

constexpr double pi = std::numbers::pi;

TEST(FourBarRange, EndsWhereCouplerAndRockerComeIntoLine) {
  const Links links{2, 3, 6, 8};
  const double limit = links.angle_at(9);
  for (const double unit : {1.0, 1000.0, 1e-3}) {
    const Model m = four_bar(links, 1, 1, unit);
    const DriverRange r = range_of(m);
    ASSERT_EQ(r.up.stop, RangeStop::dead_point);
    EXPECT_NEAR(r.up.value, limit, 1e-13);
    EXPECT_NEAR(r.down.value, -limit, 1e-13);
    EXPECT_GT(r.up.beyond, r.up.value);
    EXPECT_LT(r.up.beyond, limit + 1e-12);
    ASSERT_FALSE(r.up.moving.empty());
    EXPECT_EQ(m.entities[r.up.moving[0]].name, "0dyad1/C");
    ASSERT_EQ(r.up.groups.size(), 1u);
    EXPECT_EQ(m.groups[r.up.groups[0]].bodies,
              (std::vector<std::string>{"0dyad1/coupler", "0dyad1/rocker"}));
    EXPECT_TRUE(r.change_points.empty());
  }
}

TEST(FourBarRange, OfADriverLeavesTheOthersAtTheirStart) {
  const Model m = four_bar({2, 3, 6, 8}, 1, 1, 1, 2);
  for (int d = 0; d < 2; ++d) {
    const DriverRange r = range_of(m, d);
    EXPECT_NEAR(r.up.value, Links({2, 3, 6, 8}).angle_at(9), 1e-13);
    EXPECT_EQ(m.entities[r.up.moving[0]].name, std::to_string(d) + "dyad1/C");
  }
}

TEST(FourBarRange, IsATurnOrTwoPastTheChangePoints) {
  struct Row {
    Links links;
    int side, turns;
    std::vector<double> points;  // change points from 1 rad on
  };
  std::vector<Row> rows{{{1, 2, 1, 2}, 1, 1, {pi, 2 * pi}},      // parallelogram
                        {{1, 2, 1, 2}, -1, 1, {pi, 2 * pi}},     // antiparallelogram
                        {{1, 2, 2, 1}, 1, 2, {2 * pi, 4 * pi}},  // deltoid
                        {{2, 6, 5, 7}, 1, 1, {}}};               // Grashof's crank
  for (const double off : {1e-3, 1e-5, 1e-7, 1e-9})  // crank and ground do not reach the others
    rows.push_back({{2.25, 2.62, 2.7 + off, 3.07}, 1, 1, {}});
  for (const auto& [links, side, turns, points] : rows) {
    SCOPED_TRACE(testing::Message() << links.coupler << ", " << links.rocker << ", " << side);
    const DriverRange r = range_of(four_bar(links, 1, side));
    EXPECT_EQ(r.up.stop, RangeStop::full_turn);
    EXPECT_EQ(r.up.turns, turns);
    EXPECT_NEAR(r.up.value, 1 + turns * 2 * pi, 1e-12);
    EXPECT_EQ(r.down.stop, RangeStop::full_turn);
    ASSERT_EQ(r.change_points.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(r.change_points[i].value, points[i], 1e-9);
      if (turns == 1) EXPECT_GT(r.change_points[i].group, 0);
    }
  }
}

TEST(FourBarRange, PassesItsChangePointFromEveryStart) {
  // Steps come to lie next to the change point in every way, also where rounding decides.
  const Links kin{0.4, 1.1, 0.5, 1};
  constexpr int apart = DESMO_SANITIZED ? 60 : 3;
  for (int degrees = 9; degrees < 360; degrees += apart) {
    const double start = degrees * pi / 180;
    const DriverRange r = range_of(four_bar(kin, start));
    for (const RangeEnd& e : {r.down, r.up}) {
      EXPECT_EQ(e.stop, RangeStop::full_turn) << degrees;
      EXPECT_EQ(e.turns, 2) << degrees;
    }
    ASSERT_GE(r.change_points.size(), 2u) << degrees;
    for (const ChangePoint& c : r.change_points)
      EXPECT_NEAR(std::remainder(c.value, 2 * pi), 0, 1e-9) << degrees;
  }
}

TEST(FourBarRange, IsNeverThatOfTheOtherBranchNextToAChangePoint) {
  for (const double off : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const Links longer{1, 2 + off, 1, 2}, shorter{1, 2 - off, 1, 2};
    const DriverRange in = range_of(four_bar(longer, 1)), out = range_of(four_bar(shorter, 1));
    const double inner = longer.angle_at(longer.coupler - 1),
                 outer = shorter.angle_at(shorter.coupler + 1);
    ASSERT_EQ(in.down.stop, RangeStop::dead_point) << off;
    ASSERT_EQ(out.up.stop, RangeStop::dead_point) << off;
    EXPECT_NEAR(in.down.value, inner, 1e-16 / inner * 100 + 1e-13) << off;
    EXPECT_NEAR(in.up.value, 2 * pi - inner, 1e-16 / inner * 100 + 1e-13) << off;
    EXPECT_NEAR(out.up.value, outer, 1e-16 / (pi - outer) * 100 + 1e-13) << off;
    EXPECT_TRUE(in.change_points.empty());
    EXPECT_TRUE(out.change_points.empty());
  }
}

TEST(FourBarRange, FromADeadPointGoesOneWayOnTwoBranches) {
  const Links links{4, 3, 3.5, 8};
  const double limit = links.angle_at(6.5);
  for (const double before : {0.0, 1e-11, 3e-10, 3e-9, 1e-8}) {
    const DriverRange r = range_of(four_bar(links, limit - before));
    ASSERT_EQ(r.up.stop, RangeStop::dead_point) << before;
    EXPECT_NEAR(r.up.value, limit, 1e-13);
    EXPECT_NEAR(r.down.value, -limit, 1e-13);
    ASSERT_EQ(r.other_branch.has_value(), before < 1e-9);
    EXPECT_NEAR(r.other_branch.value_or(r.down).value, -limit, 1e-13);
  }
}

TEST(FourBarRange, FromAChangePointIsNotDetermined) {
  const DriverRange r = range_of(four_bar({1, 2, 1, 2}, 0));
  EXPECT_EQ(r.up.stop, RangeStop::start);
  EXPECT_EQ(r.down.stop, RangeStop::start);
}

TEST(FourBarRange, NeedsAPositionToStartFrom) {
  Model m = four_bar({2, 3, 6, 8}, 1);
  for (const double out_of_reach : {3.0, std::numeric_limits<double>::quiet_NaN()}) {
    m.drivers[0].motion = Polynomial{{out_of_reach}};
    EXPECT_THROW(range_of(m), std::runtime_error);
  }
}

TEST(FourBarRange, RefusesADriverOrAPositionThatTheModelHasNot) {
  const Model m = four_bar({2, 3, 6, 8}, 1);
  const std::vector<double> q = solved_start(m);
  for (const int driver : {-1, 1})
    EXPECT_THROW(find_range(m, q, driver), std::invalid_argument) << driver;
  EXPECT_THROW(find_range(m, std::span(q).first(q.size() - 1), 0), std::invalid_argument);
}

/// A rack of which 1 rad of the crank takes so much [length]. It stops where the crank does, at
/// three times the mechanism's size; at thirty times that nobody looks.
TEST(FourBarRange, OfARackIsLookedForAtUpToTenTimesTheSize) {
  const Links links{2, 3, 6, 8};
  const auto model = [&](double rack) {
    MechanismBuilder builder("rack", 2);
    builder.set_length_unit("1");
    add(builder, extremes::one_dyad(links.crank, 1, links.ground, links.coupler, links.rocker));
    const int m = builder.point("M", {0, -1, 0}), r = builder.point("R", {1, -1, 0}),
              x = builder.vector("x", {1, 0, 0});
    builder.carry(MechanismBuilder::ground, {m}, {x});
    const int body = builder.body("rack", {r}, {x});
    builder.joint(Mechanism::JointType::prismatic, MechanismBuilder::ground, body, {m, r}, {x});
    builder.along("s", m, r, x).driven = true;
    builder.couple("mesh", {{0, -rack}, {2, 1}});
    Mechanism mechanism = builder.release();
    mechanism.coordinates[0].driven = false;
    return model_mechanism(mechanism, {Polynomial{{1}}}).model;
  };
  const double size = nominal_size(model(1));
  for (const double sizes : {3, 30}) {
    const DriverRange range = range_of(model(sizes * size / (links.angle_at(9) - 1)));
    EXPECT_EQ(range.up.stop, sizes < 10 ? RangeStop::dead_point : RangeStop::none) << sizes;
    if (sizes < 10) EXPECT_NEAR(range.up.value, 1 + sizes * size, 1e-9);
    if (sizes > 10) EXPECT_NEAR(range.up.value, 1 + 10 * size, size);
  }
}

/// Doubles are 1e-7 rad apart there, more than equal values of the driver may differ.
TEST(FourBarRange, FarFromZeroIsOneTurnToo) {
  const DriverRange r = range_of(four_bar({2, 6, 5, 7}, 1 + 1e8 * 2 * pi));
  EXPECT_EQ(r.up.stop, RangeStop::full_turn);
  EXPECT_EQ(r.up.turns, 1);
  EXPECT_NEAR(r.up.value - r.start, 2 * pi, 1e-6);
}

TEST(FourBarRange, OfACrankAloneIsATurn) {
  MechanismBuilder builder("crank", 2);
  add(builder, {.crank = 1, .start = 0.5, .dyads = {}});
  const Model m = model_mechanism(builder.release(), {Polynomial{{0.5}}}).model;
  const DriverRange r = range_of(m);
  EXPECT_EQ(r.up.stop, RangeStop::full_turn);
}

}  // namespace
}  // namespace desmo::four_bar_range_test
