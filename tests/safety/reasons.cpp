// What is said of failures and of what is not right: numbers and reasons that agree.

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/assessment/limits.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "tests/dead_point.h"
#include "tests/discard.h"
#include "tests/safety/limited_motions.h"

namespace desmo {
namespace {

TEST(Reasons, AreNoDeficitWhereAPositionExists) {
  const Model m = locking_four_bar(Polynomial{{dead_point}});
  std::vector<double> state = m.estimate;
  state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
  EXPECT_FALSE(find_assembly_error(m, state, {}));
}

/// A crank that begins to turn as t⁵: the trapezoid rule leads nowhere, however short the step.
TEST(Reasons, AreNoJumpWhereAMotionStartsAtRest) {
  const Model m = locking_four_bar(Polynomial{{0.5, 0, 0, 0, 0, 1}});
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
    Discard observer;
    const MonitoredSummary s =
        run_monitored(*make_formulation(find_variant(id), m, {}), {0, 0.01, 101}, {}, observer, {});
    EXPECT_FALSE(s.crossing) << id;
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
  }
}

/// A drag link in steps of half a radian: the last of the shorter steps that repeat one is not what
/// rounding leaves of it.
TEST(Reasons, AreNoJumpWhereStepsAreLongAndAccelerationsAreNotSolved) {
  const Scene scene = parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "drag_link", "dimension": 2,
      "points": {"O": [0, 0], "A": [1.910672978251212, 0.5910404133226791], "B": [2.80948306556001, -0.8519219655881333], "D": [1, 0]},
      "ground": {"points": ["O", "D"]},
      "bodies": {"crank": {"points": ["O", "A"], "length": 2},
                 "coupler": {"points": ["A", "B"], "length": 1.7},
                 "rocker": {"points": ["D", "B"], "length": 2}},
      "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
                 {"type": "revolute", "bodies": ["crank", "coupler"], "points": ["A"]},
                 {"type": "revolute", "bodies": ["coupler", "rocker"], "points": ["B"]},
                 {"type": "revolute", "bodies": ["ground", "rocker"], "points": ["D"]}],
      "coordinates": {"theta": {"angle": ["O", "A"]}, "psi": {"angle": ["D", "B"]}},
      "drivers": ["theta"]},
    "motion": {"theta": {"type": "polynomial", "coefficients": [0.3, 30]}},
    "time": {"end": 1, "step": 0.016666666666666666}})",
                                  "drag_link.scene.json", "");
  const Model m = make_model(scene);
  for (const char* id : {"global_automatic_klu", "block_symbolic_explicit"})
    for (const Level level : all_levels) {
      Discard observer;
      const MonitoredSummary s =
          run_monitored(*make_formulation(find_variant(id), m), scene.grid, {level}, observer);
      EXPECT_EQ(s.outcome(), Outcome::converged) << id << ", " << static_cast<int>(level);
    }
}

/// Ten minutes on, times are known to 1e-13 s: what is left of a step then is no step.
TEST(Reasons, AreNoJumpAtLateTimes) {
  const Scene scene = parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "short_rod", "dimension": 2,
      "points": {"A": [0, 0], "B": [-0.9893951337727704, -0.14524899058775473], "S": [0.05051002090876988, 0]},
      "vectors": {"u": [1, 0]},
      "ground": {"points": ["A"], "vectors": ["u"]},
      "bodies": {"crank": {"points": ["A", "B"], "length": 1},
                 "rod": {"points": ["B", "S"], "length": 1.05},
                 "slider": {"points": ["S"], "vectors": ["u"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
                 {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
                 {"type": "revolute", "bodies": ["rod", "slider"], "points": ["S"]},
                 {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["u"], "points": ["A", "S"]}],
      "coordinates": {"theta": {"angle": ["A", "B"]}, "s": {"distance": ["A", "S"], "along": "u"}},
      "drivers": ["theta"]},
    "motion": {"theta": {"type": "harmonic", "mean": 0, "terms": [{"amplitude": 3.15, "frequency": 2.2}]}},
    "time": {"start": 514, "end": 515, "step": 0.016666666666666666}})",
                                  "short_rod.scene.json", "");
  const Model m = make_model(scene);
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"})
    for (const Level level : all_levels) {
      Discard observer;
      const MonitoredSummary s =
          run_monitored(*make_formulation(find_variant(id), m), scene.grid, {level}, observer);
      EXPECT_EQ(s.outcome(), Outcome::converged) << id << ", " << static_cast<int>(level);
    }
}

TEST(Reasons, NameWhatLimitsAMotion) {
  for (const LimitedMotion& m : limited_motions())
    for (const char* id : {"global_automatic_klu", "group_automatic_eigen",
                           "group_symbolic_inlined", "block_symbolic_explicit"}) {
      Discard observer;
      const MonitoredSummary s =
          run_monitored(*make_formulation(find_variant(id), m.model), m.grid, {}, observer);
      ASSERT_TRUE(s.first_degraded) << m.name << ", " << id;
      EXPECT_EQ(s.first_degraded->assessment.limit, m.limit) << m.name << ", " << id;
    }
}

/// Links of a millimetre on a crank of a thousand kilometres: rounding of points so far away is not
/// taken for a mechanism that cannot be assembled.
TEST(Reasons, AreNoDeficitWhereLengthsDiffer) {
  const Scene scene = small_dyad(1e6);
  const Model m = make_model(scene);
  Discard observer;
  const MonitoredSummary s = run_monitored(
      *make_formulation(find_variant("global_automatic_klu"), m, {}), scene.grid, {}, observer, {});
  EXPECT_NE(s.outcome(), Outcome::failed);
}

/// Speeds of which rounding leaves no digit are no singular position.
TEST(Reasons, NameRoundedDriversWhereNoPositionIsLeft) {
  const Model m = locking_four_bar(Polynomial{{0.5, 1e99}});
  Discard observer;
  const MonitoredSummary s = run_monitored(
      *make_formulation(find_variant("global_automatic_klu"), m), {0, 0.1, 3}, {}, observer);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  EXPECT_EQ(s.limit, Limit::drivers);
}

/// Outcome and bounds are one: what is stated beyond the limits is degraded, and only that.
TEST(Reasons, StateBoundsThatAgreeWithTheOutcome) {
  for (const std::size_t power : {1, 2, 3, 5}) {
    std::vector<double> coefficients{0.5, 0, 0, 0, 0, 0};
    coefficients[power] = 0.5;
    const Model m = locking_four_bar(Polynomial{coefficients});
    for (const char* id : {"global_automatic_klu", "group_automatic_lapack",
                           "group_symbolic_inlined", "group_symbolic_explicit"}) {
      Discard observer;
      const MonitoredSummary s = run_monitored(*make_formulation(find_variant(id), m, {}),
                                               {0, 0.01, 101}, {}, observer, {});
      EXPECT_FALSE(s.crossing) << id << ", t^" << power;
      EXPECT_EQ(s.degraded > 0, exceeds(s.bound, Limits(1e-12).degraded)) << id << ", t^" << power;
      EXPECT_EQ(s.degraded > 0, s.first_degraded.has_value()) << id << ", t^" << power;
    }
  }
}

}  // namespace
}  // namespace desmo
