// Scales of a run while it goes on.

#include "formulations/verification/run/running_scales.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "formulations/verification/run/row_tally.h"
#include "tests/dead_point.h"

namespace desmo::running_scales_test {
namespace {

/// What has hardly moved yet is not measured by that: a rest in which drivers turn has rates that
/// are rounding alone. Three hundredths of what drivers do is a motion, three thousandths is none.
TEST(RunningScales, AreAtLeastAHundredthOfWhatDriversDo) {
  const Model m = locking_four_bar(Polynomial{{1, 2}});  // 2 rad/s
  const double size = nominal_size(m);
  const int x = m.coordinate("dyad1/C.x");
  std::vector<double> q = m.estimate, qd(m.coordinates()), qdd(m.coordinates());
  for (const double share : {0.003, 0.03}) {
    RunningScales scales(m, {0, 0.1, 11});
    EXPECT_EQ(scales.current().rotation.velocity, 2);
    qd[x] = share * size * 2;
    scales.take({.index = 0, .time = 0, .q = q, .qd = qd, .qdd = qdd});
    const double expected = std::max(share, 0.01) * size * 2;
    EXPECT_DOUBLE_EQ(scales.current().length.velocity, expected);
    // Likewise what does not accelerate.
    EXPECT_DOUBLE_EQ(scales.current().length.acceleration, 0.01 * expected * expected / size);
  }
}

/// All rows are looked at beforehand, however many steps lie between them.
TEST(RunningScales, BeginWithTheLargestRatesOfDrivers) {
  const Model m = locking_four_bar(HarmonicSum{1, {{0.1, 1, 0}}});  // rests at π/2
  const RunningScales scales(m, {std::acos(0.), 0.1, 11, 5});
  double largest = 0;
  for (int i = 0; i < 11; ++i)
    largest = std::max(largest, std::abs(0.1 * std::cos(std::acos(0.) + 0.5 * i)));
  EXPECT_DOUBLE_EQ(scales.current().rotation.velocity, largest);
}

/// Rates next to a lock are no scale of what is proven elsewhere.
TEST(RowTally, TakesNoScaleFromWhatIsNotProven) {
  const Model m = locking_four_bar(Polynomial{{1, 2}});
  RowTally tally(m, {0, 0.1, 11});
  CheckedSummary summary, before;
  tally.finish(before);
  const std::vector<double> rates(m.coordinates(), 1e6), none(m.coordinates(), INFINITY);
  CheckedInstant row{.instant = instant_of(0, {rates, rates, rates}, Level::acceleration),
                     .radius = {none, none, none}};
  row.flag = {.kind = RowFlag::Kind::unproven};
  tally.take(row, summary);
  tally.finish(summary);
  EXPECT_EQ(summary.flagged, 1);
  EXPECT_EQ(summary.scales.length.velocity, before.scales.length.velocity);
  row.flag.reset();
  const std::vector<double> proven(m.coordinates(), 0);
  row.radius = {proven, proven, proven};
  tally.take(row, summary);
  tally.finish(summary);
  EXPECT_GE(summary.scales.length.velocity, 1e6);
}

}  // namespace
}  // namespace desmo::running_scales_test
