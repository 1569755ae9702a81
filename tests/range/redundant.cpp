// Ranges of mechanisms with more equations than unknowns.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "cases/extremes/extremes.h"
#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "tests/overconstrained.h"
#include "tests/range/solved_start.h"

namespace desmo::redundant_range_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(RedundantRange, KeepsToTheBranchOnWhichAllEquationsHold) {
  const std::vector<ExtremeCase> cases = find_extreme(6).cases(Extent::brief);
  const Model cranks = make_model(cases[0].scene), bricard = make_model(cases[1].scene);
  const DriverRange r = range_of(cranks);
  EXPECT_EQ(r.up.stop, RangeStop::full_turn);
  EXPECT_EQ(r.up.turns, 1);
  ASSERT_EQ(r.change_points.size(), 2u);
  EXPECT_NEAR(r.change_points[0].value, pi, 1e-9);
  const DriverRange b = range_of(bricard);
  EXPECT_NEAR(b.down.value, -pi / 6, 1e-9);
  EXPECT_NEAR(b.up.value, 7 * pi / 6, 1e-9);
  for (const RangeEnd* end : {&b.down, &b.up}) {  // where its equations are dependent, all of them
    EXPECT_EQ(end->stop, RangeStop::dead_point);
    EXPECT_FALSE(end->moving.empty());
    EXPECT_LT(std::abs(end->beyond - end->value), 1e-9);
  }
}

/// Two belts whose rods are a quarter turn apart: where one is in line, the other is not. Modelling
/// keeps the equations of one.
TEST(RedundantRange, HasNoSingularPositionWhereOtherEquationsAreIndependent) {
  const Model m =
      make_model(read_scene(DESMO_SOURCE_DIR "/tests/range/scenes/quartered_rods.json"));
  const DriverRange r = range_of(m);
  for (const RangeEnd* end : {&r.down, &r.up}) {
    EXPECT_EQ(end->stop, RangeStop::full_turn);
    EXPECT_EQ(end->turns, 1);
  }
  EXPECT_TRUE(r.change_points.empty());
}

/// Equations that are left out may be off by what modelling lets digits leave, 1e-4.
TEST(RedundantRange, GoesOnWhereALinkageClosesToTheDigitsOfItsFile) {
  for (const int digits : {17, 6, 5}) {
    const Model m = make_model(bennett(0.8L, digits));
    const DriverRange r = range_of(m);
    for (const RangeEnd* end : {&r.down, &r.up})
      EXPECT_EQ(end->stop, RangeStop::full_turn) << digits;
  }
}

TEST(RedundantRange, StartsWhereOnlyTheEquationsKeptAreDependent) {
  const Model m =
      make_model(read_scene(DESMO_SOURCE_DIR "/tests/checked/scenes/bennett_folded_start.json"));
  const DriverRange r = range_of(m);
  EXPECT_EQ(r.up.stop, RangeStop::full_turn);
  EXPECT_EQ(r.up.turns, 1);
  EXPECT_TRUE(r.change_points.empty());
}

}  // namespace
}  // namespace desmo::redundant_range_test
