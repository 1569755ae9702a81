// No heap in a step. What UMFPACK and SPQR allocate inside is counted and printed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "bench/kit/variant_costs.h"
#include "bench/peers/peer.h"
#include "cases/generators/cases.h"
#include "formulations/algebra/backend.h"
#include "formulations/variants.h"
#include "formulations/verification/error.h"
#include "formulations/verification/reference/reference.h"
#include "formulations/verification/run/checked_run.h"
#include "formulations/verification/run/live_run.h"
#include "tests/allocation/heap_counter.h"
#include "tests/dead_point.h"
#include "tests/discard.h"
#include "tests/every_variant.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::allocation_test {
namespace {

bool allocates_inside(const Variant& v) {
  const Backend* const library = find_backend(v.algebra);
  return library && library->allocates;
}

constexpr int steps = 50;

/// Assembles at t = 0, and returns the allocations of the steps after it, all of which are solved.
long allocations_of_steps(Formulation& f) {
  EXPECT_TRUE(f.assemble(0).ok());
  bool ok = true;
  const long n = count([&] {
    for (int i = 1; i <= steps; ++i) ok = f.step(0.01 * i).ok() && ok;
  });
  EXPECT_TRUE(ok);
  return n;
}

EVERY_VARIANT(EveryStep);

TEST_P(EveryStep, AllocatesNothingInAStep) {
  const Variant& v = GetParam();
  for (const Case& c : cases()) {
    const Model m = make_model(make_scene(c, bench::is_dense_global(v) ? 114 : 558));
    const long n = allocations_of_steps(*make_formulation(v, m));
    if (allocates_inside(v))
      std::cout << v.id << ", " << c.name << ": the library allocates "
                << static_cast<double>(n) / steps << " times a step\n";
    else
      EXPECT_EQ(n, 0) << c.name;
  }
}

TEST(Measures, AllocateNothingWhileInstantsArrive) {
  const Model m = make_model(make_scene(cases().back(), 114));
  const std::vector<double> times{0, 0.1, 0.2};
  const Reference reference = make_reference(m, times);
  ErrorMeasure error(m, reference.instants, reference.scales);
  const long n = count([&] {
    for (int i = 0; i <= 2; ++i) {
      const ReferenceInstant& r = reference.instants[i];
      error.observe({i, r.time, r.q, r.qd, r.qdd});
    }
  });
  EXPECT_EQ(n, 0);
  EXPECT_EQ(error.error().instants, 3);
}

/// Once warm: a pivot order that has to be chosen anew is KLU's to allocate.
TEST_P(EveryStep, AllocatesNothingInAStepWhateverTheSettings) {
  if (allocates_inside(GetParam())) return;  // counted above
  const Model m = make_model(make_scene(find_case("truck_suspension"), 114));
  for (const char* suffixes :
       {"/guess:linear", "/guess:quadratic", "/guess:hermite3", "/guess:hermite5", "/guess:adams8",
        "/jacobian:step", "/guess:hermite5/jacobian:step", "/tolerance:1e-6", "/iterations:2"}) {
    const std::string id = offered_id(suffixes);
    if (id.empty()) continue;
    SCOPED_TRACE(suffixes);
    EXPECT_EQ(allocations_of_steps(*formulated(id, m)), 0);
  }
}

TEST_P(EveryStep, AllocatesNothingInAStepWhateverTheCoordinates) {
  const Variant& v = GetParam();
  if (v.evaluation == Evaluation::symbolic || allocates_inside(v)) return;
  for (const Modelling kind : {Modelling::basis, Modelling::reference, Modelling::relative}) {
    const Model m = make_model(make_scene(find_case("truck_suspension"), 114), kind);
    for (const Frames frames : {Frames::linearised, Frames::exact}) {
      const Settings settings{.coordinates = kind, .frames = frames};
      if (!unsupported_reason(v, settings).empty()) continue;
      SCOPED_TRACE(id_with(v, settings));
      EXPECT_EQ(allocations_of_steps(*make_formulation(v, m, settings)), 0);
    }
  }
}

TEST(TreePeers, AllocateNothingInAStep) {
  for (const PeerDefinition& peer : peers()) {
    if (!peer.is_by_hand) continue;  // libraries do as they like
    for (const Case& c : cases()) {
      const Scene scene = make_scene(c, 558);
      const Model m = make_model(scene);
      const auto solver = peer.make(scene, m);
      solver->assemble(0);
      const long n = count([&] {
        for (int i = 1; i <= 50; ++i) solver->step(0.01 * i);
      });
      EXPECT_EQ(n, 0) << c.name << ", " << peer.name;
    }
  }
}

/// Interpolation takes its memory once a motion, however many instants that has.
TEST(DenseOutput, AllocatesNothingFromInstantToInstant) {
  Discard observer;
  const Model m = make_model(make_scene(find_case("truck_suspension"), 114));
  const auto f = make_formulation(find_variant("group_symbolic_klu"), m, {.stride = 8});
  ASSERT_TRUE(f->run(time_grid(1, 0.01), {}, observer).ok());
  bool ok = true;
  const long once = count([&] { ok = f->run(time_grid(0.08, 0.01), {}, observer).ok(); });
  EXPECT_GT(once, 0);
  EXPECT_EQ(count([&] { ok = f->run(time_grid(1, 0.01), {}, observer).ok() && ok; }), once);
  EXPECT_TRUE(ok);
}

/// Counts what the heap gives from one row to the next.
class CountedRows final : public Observer {
 public:
  Flow observe(const Instant&) noexcept override {
    const long since_last_row = end_counting();
    if (instants++ > 0) most = std::max(most, since_last_row);
    begin_counting();
    return Flow::go_on;
  }
  int instants = 0;
  long most = 0;
};

/// Ordinary rows, solved or interpolated.
TEST_P(EveryStep, AllocatesNothingFromRowToRowOfACheckedRun) {
  const Variant& v = GetParam();
  if (allocates_inside(v)) return;
  for (const Case& c : cases()) {
    const Model m = make_model(make_scene(c, 114));
    for (const int stride : {1, 4}) {
      CountedRows rows;
      const CheckedSummary s =
          run_checked(*make_formulation(v, m, {.stride = stride}), time_grid(0.2, 0.01), {}, rows);
      end_counting();
      EXPECT_EQ(s.outcome(), Outcome::converged) << c.name;
      EXPECT_EQ(rows.instants, 21) << c.name;
      EXPECT_EQ(rows.most, 0) << c.name << ", stride " << stride;
    }
  }
}

/// Rows that are solved at once, by sub-steps or not at all, and those that are no rows.
TEST_P(EveryStep, AllocatesNothingWhateverRowIsHandedIn) {
  const Variant& v = GetParam();
  if (allocates_inside(v) || v.algebra == "klu") return;  // which chooses pivots anew
  const Model m = locking_four_bar();
  for (const Level level : all_levels) {
    const auto f = make_formulation(v, m);
    LiveRun run(*f, {.level = level});
    const std::vector<double> one{1}, none{0};
    std::vector<double> z{std::numbers::pi / 3};
    // The first row is the drawing; libraries take their memory where they first factorise.
    ASSERT_EQ(run.step({0, z, one, none}).outcome(), Outcome::converged);
    z[0] -= 0.1;
    ASSERT_EQ(run.step({5e-4, z, one, none}).outcome(), Outcome::converged);
    long failed = 0, in_sub_steps = 0;
    const long n = count([&] {
      for (int i = 1; i <= 250; ++i) {
        z[0] = i % 7 == 0 ? 2.2 : 0.8 * std::sin(0.1 * i * i);
        if (i % 25 == 0) z[0] = NAN;
        const LiveSummary s = run.step({1e-3 * i, z, one, none});
        failed += s.outcome() == Outcome::failed;
        in_sub_steps += s.path.sub_steps > 1;
      }
    });
    EXPECT_GT(failed, 25);
    EXPECT_GT(in_sub_steps, 25);
    EXPECT_EQ(n, 0) << failed << " failed, " << in_sub_steps << " followed in sub-steps";
  }
}

}  // namespace
}  // namespace desmo::allocation_test
