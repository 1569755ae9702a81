// What a monitored run need not do again.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "formulations/variants.h"
#include "formulations/verification/assessment/assessor.h"
#include "formulations/verification/monitor/condition_monitor.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "tests/accuracy/scenes.h"
#include "tests/discard.h"

namespace desmo::price_test {
namespace {

TEST(Price, APositionIsLookedAtOnce) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = Polynomial{{0, 1}};
  constexpr int steps = 500;  // a turn
  const auto f = make_formulation(find_variant("global_automatic_eigen"), m);
  Assessor assessor(m);
  ScaledSystem& system = assessor.system();
  ConditionMonitor monitor(m, system, assessor.row_magnitudes());
  std::vector<int> looks(3, 0);  // of each turn
  std::vector<double> state(m.state_size());
  std::ranges::copy(m.fixed_values, state.begin() + m.coordinates());
  for (int i = 0; i < 3 * steps; ++i) {
    const double t = i * 2 * std::numbers::pi / steps;
    ASSERT_TRUE(f->step(t).ok());
    const Instant instant{i, t, f->q(), f->qd(), f->qdd()};
    monitor.go_on(instant, {});
    if (i == 0) {
      std::ranges::copy(instant.q, state.begin());
      ASSERT_TRUE(system.factor(state));
      monitor.reset(instant, system, Eigen::ArrayXd::Zero(m.coordinates()));
    } else if (monitor.is_due()) {
      monitor.look(instant, system);
      ++looks[i / steps];
    }
    ASSERT_LT(monitor.growth(), 100) << t;
  }
  EXPECT_GE(looks[0], 3);
  EXPECT_LE(looks[1], 1);
  EXPECT_EQ(looks[2], 0);
}

TEST(Price, WhatTheToleranceLeavesIsCorrectedWithoutAnAssessment) {
  const Scene scene = library_scene("delta");
  const Model m = make_model(scene);
  for (const char* id : {"group_symbolic_inlined", "block_symbolic_inlined"}) {
    const auto f = make_formulation(find_variant(id), m);
    Discard discard;
    const MonitoredSummary s = run_monitored(*f, scene.grid, {}, discard);
    EXPECT_EQ(s.outcome(), Outcome::converged) << id;
    EXPECT_LE(s.assessed, scene.grid.instants / 10) << id;
  }
}

}  // namespace
}  // namespace desmo::price_test
