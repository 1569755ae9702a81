// Whole runs, watched: what ordinary motions, dead points and change points end as.

#include "formulations/safety/safe_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formulations/accuracy/error.h"
#include "formulations/reference.h"
#include "formulations/variants.h"
#include "tests/accuracy/scenes.h"
#include "tests/safety/dead_point.h"

namespace desmo {
namespace {

class Discard final : public Sink {
 public:
  void accept(const Instant&) override {}
};

SafeSummary run(const Mechanism& m, const TimeGrid& grid, const char* id, Sink& sink,
                SafetyOptions options = {}, const Settings& settings = {}) {
  return run_safely(*make_formulation(find_variant(id), m, settings), grid, {}, sink, options);
}

TEST(SafeRun, FindsOrdinaryMotionsConverged) {
  for (const char* id :
       {"global_automatic_klu", "group_symbolic_inlined", "group_symbolic_explicit"})
    for (const auto& [m, grid] : every_motion()) {
      Discard sink;
      const SafeSummary s = run(m, grid, id, sink);
      EXPECT_EQ(s.outcome(), Outcome::converged)
          << m.name << ", " << id << ": " << describe_accuracy(s.condition, s.bound, Level::acceleration);
      EXPECT_EQ(s.instants, grid.instants);
      EXPECT_LT(s.assessed, 8 + s.instants / 100) << m.name << ", " << id;
    }
}

/// Of every instant when all are assessed; otherwise where signals show what happens.
TEST(SafeRun, BoundsTheErrorsOfLibraryMotions) {
  for (const LibraryMechanism& l : library()) {
    const Scene scene = library_scene(l.name);
    const Mechanism m = make_mechanism(scene);
    const Reference reference = make_reference(m, sampled(scene.grid, 33));
    for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
      for (const int every : {1, 1000}) {
        ErrorMeasure measure(m, reference.instants, reference.scales);
        SafetyOptions options;
        options.every = every;
        const SafeSummary s = run(m, scene.grid, id, measure, options);
        ASSERT_EQ(measure.error().instants, 33);
        for (const Level level : levels) {
          const double hidden = every > 1 && level != Level::position ? 100 : 1;
          EXPECT_LE(measure.error()[level].max, hidden * s.bound[level]) << l.name << ", " << id;
        }
      }
    }
  }
}

/// A crank that swings up to its dead point but for a little, and back.
Mechanism swinging(double distance) {
  constexpr double amplitude = 0.5;
  return locking_four_bar(
      HarmonicSum{dead_point - distance - amplitude, {{amplitude, 2 * std::numbers::pi, 0}}});
}

TEST(SafeRun, IsDegradedNearADeadPointAndRightToItsBounds) {
  for (const double distance : {1e-11, 1e-12})
    for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
      const Mechanism m = swinging(distance);
      const TimeGrid grid{0, 1e-3, 501};
      const Reference reference = make_reference(m, std::vector{0.1, 0.249, 0.25});
      ErrorMeasure measure(m, reference.instants, reference.scales);
      const SafeSummary s = run(m, grid, id, measure);
      EXPECT_EQ(s.outcome(), Outcome::degraded) << distance << ", " << id;
      ASSERT_TRUE(s.first_degraded);
      EXPECT_NEAR(s.first_degraded->time, 0.25, 0.002);
      EXPECT_LT(s.degraded, 8);
      EXPECT_GT(s.condition, 0.2 / std::sqrt(distance));
      for (const Level level : levels)
        EXPECT_LE(measure.error()[level].max, s.bound[level]) << distance << ", " << id;
    }
}

TEST(SafeRun, FailsAtASingularPosition) {
  const Mechanism m = locking_four_bar(Polynomial{{dead_point - 0.25, 1}});
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"}) {
    Discard sink;
    const SafeSummary s = run(m, {0, 0.25, 2}, id, sink);
    EXPECT_EQ(s.outcome(), Outcome::failed) << id;
    EXPECT_EQ(s.instants, 1) << id;
    EXPECT_NEAR(s.time, 0.25, 1e-12) << id;
    ASSERT_GE(s.group, 0) << id;
    EXPECT_EQ(m.groups[s.group].name, "dyad1/SG-I") << id;
  }
}

TEST(SafeRun, StrictEndsAtTheFirstDegradedInstant) {
  const Mechanism m = swinging(1e-11);
  Discard sink;
  const SafeSummary s = run(m, {0, 1e-3, 501}, "group_symbolic_inlined", sink, {{}, true});
  EXPECT_TRUE(s.refused);
  EXPECT_EQ(s.outcome(), Outcome::failed);
  ASSERT_TRUE(s.first_degraded);
  EXPECT_EQ(s.instants, s.first_degraded->index);
}

/// A parallelogram turns through its change points with rates that are as ever.
Mechanism parallelogram() {
  Mechanism m = four_bar_mechanism(1);
  for (Constraint& c : m.constraints)
    if (c.group == 1 && c.kind == kind_index<PlanarAngle>()) c.constants[0] = 2;  // the rocker
  const auto at = [&](const char* name) { return m.entities[m.find(name)].first; };
  m.estimate[at("dyad1/C")] = 7;
  m.estimate[at("dyad1/C") + 1] = std::sqrt(3.0);
  m.estimate[at("dyad1/psi")] = std::numbers::pi / 3;
  return m;
}

TEST(SafeRun, SaysThatAChangePointWasPassed) {
  const Mechanism m = parallelogram();
  Discard sink;
  const TimeGrid grid{0, 0.01, 400};  // θ = π/3 + t passes π at 2.09 s
  SafetyOptions options;
  options.every = 50;
  const SafeSummary s = run(m, grid, "group_symbolic_inlined", sink, options, {.guess = Guess::quadratic});
  EXPECT_EQ(s.outcome(), Outcome::degraded);
  ASSERT_TRUE(s.crossing);
  EXPECT_LE(s.crossing->after, 2 * std::numbers::pi / 3);
  EXPECT_GE(s.crossing->before, 2 * std::numbers::pi / 3);
  EXPECT_EQ(m.groups[s.crossing->group].name, "dyad1/SG-I");
}

}  // namespace
}  // namespace desmo
