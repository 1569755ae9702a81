// Positions in which a mechanism could go on in two ways, and positions next to them: right to the
// bounds stated and flagged, whatever is asked for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/extremes/rows.h"
#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "tests/discard.h"
#include "tests/safety/recipes.h"
#include "tests/safety/scott_russell.h"

namespace desmo::change_points_test {
namespace {

MonitoredSummary run(const Model& m, const TimeGrid& grid, const std::string& id, Level level,
                     Observer& observer) {
  const Configuration c = parse_id(id);
  return run_monitored(*make_formulation(*c.variant, m, c.settings), grid, {level}, observer);
}

std::vector<std::string> every_id() {
  std::vector<std::string> ids;
  for (const Variant& v : variants())
    if (unavailable_reason(v.id).empty()) ids.push_back(v.id);
  ids.push_back("global_automatic_klu/jacobian:chord");
  for (const char* settings : {"/guess:hermite5", "/guess:adams8", "/stride:4"})
    for (const char* id : {"global_automatic_klu", "block_symbolic_explicit"})
      ids.push_back(std::string(id) + settings);
  return ids;
}

TEST(ChangePoints, ArePassedSmoothlyAndFlagged) {
  for (const double degrees : {2, 1}) {
    const Scene scene = scott_russell(degrees / 30);
    const Model m = make_model(scene);
    for (const std::string& id : every_id())
      for (const Level level : all_levels) {
        SliderError error(m);
        const MonitoredSummary s = run(m, scene.grid, id, level, error);
        EXPECT_EQ(s.outcome(), Outcome::degraded) << id << " in steps of " << degrees;
        EXPECT_EQ(s.instants, scene.grid.instants) << id;
        ASSERT_TRUE(s.crossing) << id;
        EXPECT_LE(s.crossing->after, 2) << id;
        EXPECT_GE(s.crossing->before, 2 - 1e-9) << id;
        EXPECT_LE(error.there, 1e-4) << id;
        EXPECT_LE(error.elsewhere, 1e-7) << id;
      }
  }
}

/// Nothing tells how the motion would go on.
TEST(ChangePoints, FailWhereTheMotionStartsThere) {
  Scene scene = scott_russell(1. / 15);
  scene.grid.start = 2;
  scene.grid.instants = 4;
  const Model m = make_model(scene);
  Discard observer;
  EXPECT_EQ(run(m, scene.grid, "global_automatic_klu", Level::acceleration, observer).outcome(),
            Outcome::failed);
}

TEST(ChangePoints, ShowInTheConditionStatedAMillionthBesideThem) {
  const Scene scene =
      parallelogram(Polynomial{{std::numbers::pi - 1e-6, 1}}, {-2.5, 1. / 128, 321});
  const Model m = make_model(scene);
  for (const char* id : {"global_automatic_klu/guess:hermite5", "global_automatic_klu/guess:linear",
                         "group_symbolic_inlined/guess:hermite3"})
    for (const Level level : all_levels) {
      RockerError rocker(m);
      const MonitoredSummary s = run(m, scene.grid, id, level, rocker);
      EXPECT_NE(s.outcome(), Outcome::failed) << id;
      EXPECT_GT(s.condition, 1e6) << id;
      EXPECT_LE(rocker.error.position, s.bound.position) << id;
    }
}

/// κ is 1e4 there, and the direction of Φ decides how much of it shows.
TEST(ChangePoints, LeaveErrorsWithinTheBoundsWhereACrankRocksNextToThem) {
  const Scene scene = parallelogram(
      HarmonicSum{std::numbers::pi - 0.501, {{0.5, std::numbers::pi, std::numbers::pi / 2}}},
      {0, 1. / 512, 2049});
  const Model m = make_model(scene);
  for (const char* id : {"global_automatic_klu", "group_symbolic_inlined",
                         "group_symbolic_explicit", "global_automatic_klu/jacobian:chord"}) {
    RockerError rocker(m);
    const MonitoredSummary s = run(m, scene.grid, id, Level::position, rocker);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_LE(rocker.error.position, s.bound.position) << id;
    EXPECT_LE(rocker.error.position, 1e-10) << id;
  }
}

const Scene& folded(std::string_view name) {
  static const std::vector<ExtremeCase> all = extremes::redundant(Extent::brief);
  return std::ranges::find(all, name, &ExtremeCase::name)->scene;
}

class Positions final : public Observer {
 public:
  Flow observe(const Instant& i) noexcept override {
    values.insert(values.end(), i.q.begin(), i.q.end());
    values.insert(values.end(), i.qd.begin(), i.qd.end());
    return Flow::go_on;
  }
  std::vector<double> values;
};

/// Drawn folded, Bennett's linkage keeps equations that are regular there. Drawn elsewhere it keeps
/// others, which are not.
TEST(Redundant, LinkageIsFollowedFromWhereTheEquationsKeptAreSingular) {
  const Scene& from_there = folded("Bennett's mechanism from there");
  Scene elsewhere = folded("Bennett's mechanism past there");
  elsewhere.motions = from_there.motions;
  for (const char* id :
       {"global_automatic_klu", "group_automatic_lapack", "block_automatic_eigen"}) {
    Positions expected, found;
    for (const auto& [scene, positions] :
         {std::pair(&from_there, &expected), std::pair(&std::as_const(elsewhere), &found)}) {
      const MonitoredSummary s =
          run(make_model(*scene), scene->grid, id, Level::acceleration, *positions);
      EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    }
    ASSERT_EQ(found.values.size(), expected.values.size()) << id;
    double off = 0;
    for (std::size_t i = 0; i < found.values.size(); ++i)
      off = std::max(off, std::abs(found.values[i] - expected.values[i]));
    EXPECT_LE(off, 1e-10) << id;
  }
}

/// An instant at rest says nothing of the velocities that follow.
TEST(Bounds, OfRatesFollowTheDriversWhereAMotionStartsAtRest) {
  const Scene scene = parallelogram(Polynomial{{1, 0, 0.25}}, {0, 0.01, 101});
  const Model m = make_model(scene);
  for (const std::string& id : every_id()) {
    RockerError rocker(m);
    const MonitoredSummary s = run(m, scene.grid, id, Level::velocity, rocker);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_GT(s.bound.velocity, 1e-15) << id;
    EXPECT_LE(rocker.error.velocity / 0.5, s.bound.velocity) << id;
  }
}

}  // namespace
}  // namespace desmo::change_points_test
