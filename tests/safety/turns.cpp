// Drivers that turn back between two instants, within the reach of the mechanism or out of it.

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "formulations/id.h"
#include "formulations/variants.h"
#include "formulations/verification/monitor/live_run.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "tests/dead_point.h"
#include "tests/discard.h"

namespace desmo::turns_test {
namespace {

/// The instant before the crank turns [s], its rate there and half its deceleration.
constexpr double before = 4, rate = 0.01, half = 0.05;

/// A crank that turns 0.1 s after an instant, at which it lacks `left` to its dead point. It goes
/// on by 5e-4 rad.
Model turning_four_bar(double left) {
  return locking_four_bar(Polynomial{{dead_point - left - rate * before - half * before * before,
                                      rate + 2 * half * before, -half}});
}

TEST(Turns, OutOfReachAreFlagged) {
  const Model m = turning_four_bar(1e-10);
  for (const char* id : {"global_automatic_klu", "block_symbolic_explicit",
                         "global_automatic_klu/stride:2", "global_automatic_klu/guess:hermite5"}) {
    const Configuration c = parse_id(id);
    Discard observer;
    const MonitoredSummary s =
        run_monitored(*make_formulation(*c.variant, m, c.settings), {0, 1, 9}, {}, observer);
    EXPECT_NE(s.outcome(), Outcome::converged) << id;
    if (s.status != Status::solved) continue;
    ASSERT_TRUE(s.crossing) << id << ": " << describe(s, m);
    EXPECT_LE(s.crossing->after, 4.1) << id;
    EXPECT_GE(s.crossing->before, 4) << id;
  }
}

TEST(Turns, WithinReachAreNotFlagged) {
  const Model m = turning_four_bar(0.02);
  Discard observer;
  const MonitoredSummary s = run_monitored(
      *make_formulation(find_variant("global_automatic_klu"), m), {0, 1, 9}, {}, observer);
  EXPECT_EQ(s.outcome(), Outcome::converged) << describe(s, m);
}

/// Of rows nothing is known between them but what they say: a polynomial through both. Later rows
/// are flagged, too, like a run as a whole: they go on from there.
TEST(Turns, BetweenRowsAreFlaggedFromThenOn) {
  const Model m = turning_four_bar(1e-10);
  const auto f = make_formulation(find_variant("global_automatic_klu"), m);
  LiveRun live(*f);
  const auto step = [&](double t) {
    const MotionSample<double> z = sample(m.drivers[0].motion, t);
    const std::vector<double> position{z.position}, velocity{z.velocity}, second{z.acceleration};
    return live.step({t, position, velocity, second});
  };
  for (int t = 0; t <= 8; ++t) {
    const LiveSummary s = step(t);
    if (t == before) continue;  // so near the dead point that the steps of a row may not suffice
    EXPECT_EQ(s.outcome() == Outcome::converged, t < before) << t;
    EXPECT_EQ(s.crossing.has_value(), t == before + 1) << t;
  }
  live.restart();
  EXPECT_EQ(step(0).outcome(), Outcome::converged);
}

}  // namespace
}  // namespace desmo::turns_test
