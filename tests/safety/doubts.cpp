// What follows from a step that does not look continuous.

#include <gtest/gtest.h>

#include "cases/generators/cases.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "tests/discard.h"
#include "tests/safety/scott_russell.h"

namespace desmo {
namespace {

/// At the change point shorter steps lead where the long one did, for they too end anywhere.
TEST(Doubts, EndInAnAssessmentWhereShorterStepsArgueThemAway) {
  for (const double degrees : {2, 1}) {
    const Scene scene = scott_russell(degrees / 30);
    const Model m = make_model(scene);
    for (const Variant& v : variants()) {
      if (!unavailable_reason(v.id).empty()) continue;
      Discard observer;
      const MonitoredSummary s =
          run_monitored(*make_formulation(v, m, {}), scene.grid, {}, observer, {});
      EXPECT_NE(s.outcome(), Outcome::converged) << v.id << " in steps of " << degrees;
      EXPECT_NEAR(s.time, 2, 1e-9) << v.id;
      EXPECT_EQ(s.status, Status::singular) << v.id;
    }
  }
}

}  // namespace
}  // namespace desmo
