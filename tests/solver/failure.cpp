// Instants that cannot be solved: their summary names the group, the constraint and the time.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "cases/extremes/rows.h"
#include "cases/generators/cases.h"
#include "formulations/algebra/backend.h"
#include "formulations/model/magnitudes.h"
#include "formulations/model/partition.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/internals.h"
#include "formulations/parts/inlined_part.h"
#include "formulations/parts/newton_part.h"
#include "formulations/variants.h"
#include "tests/contains.h"
#include "tests/dead_point.h"
#include "tests/discard.h"
#include "tests/every_variant.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::failure_test {
namespace {

EVERY_VARIANT(EveryFailure);

/// The second dyad is pulled apart: its ground pivot is out of reach from the start.
TEST_P(EveryFailure, NamesTheGroupThatCannotBeAssembled) {
  Model m = four_bar_model(3);
  m.fixed_values[m.entities[m.find("dyad2/D")].first] = 100;
  const auto f = make_formulation(GetParam(), m);
  Discard observer;
  const Summary s = f->run(time_grid(1, 0.01), {}, observer);
  ASSERT_FALSE(s.ok());
  ASSERT_GE(s.group, 0);
  EXPECT_EQ(observer.instants, 0);
  EXPECT_EQ(s.time, 0);
  EXPECT_EQ(m.groups[s.group].name, "dyad2/SG-I");
  EXPECT_TRUE(m.constraints[s.constraint].name.starts_with("dyad2")) << s.constraint;
  EXPECT_CONTAINS(describe(s, m), "'dyad2/SG-I'");
}

/// The loop cannot close any more from a known instant on.
TEST_P(EveryFailure, NamesTheInstantOfALockUp) {
  const Model m = locking_four_bar();
  const double lock = dead_point - std::numbers::pi / 3;
  const auto f = make_formulation(GetParam(), m);
  Discard observer;
  const Summary s = f->run(time_grid(3, 0.01), {}, observer);
  ASSERT_FALSE(s.ok());
  ASSERT_GE(s.group, 0);
  EXPECT_EQ(m.groups[s.group].name, "dyad1/SG-I");
  EXPECT_NEAR(s.time, lock, 0.011) << describe(s, m);
  EXPECT_EQ(observer.instants, static_cast<int>(std::lround(s.time / 0.01)));
}

TEST_P(EveryFailure, CallsWhatIsNotFiniteByItsName) {
  Model m = four_bar_model(2);
  m.estimate[m.entities[m.find("dyad2/C")].first] = std::numeric_limits<double>::quiet_NaN();
  const Summary s = make_formulation(GetParam(), m)->assemble(0);
  EXPECT_EQ(s.status, Status::not_finite);
  ASSERT_GE(s.group, 0);
  EXPECT_EQ(m.groups[s.group].name, "dyad2/SG-I");
}

TEST_P(EveryFailure, AssemblesWhenAStepComesFirst) {
  const Model m = truck_model(1);
  const auto a = make_formulation(GetParam(), m), b = make_formulation(GetParam(), m);
  ASSERT_TRUE(a->step(0.2).ok());
  ASSERT_TRUE(b->assemble(0.2).ok());
  EXPECT_TRUE(std::ranges::equal(a->q(), b->q()));
}

/// A time that is not a number leaves no trace, nor does a locked position.
TEST_P(EveryFailure, GoesOnFromThePositionsBeforeIt) {
  struct Walk {
    Model m;
    double before, failing, after;  // s
  };
  const DyadChain chain = extremes::one_dyad(2, 0, 6, 5, 1.5);  // locks at 1.66 rad
  const Walk walks[] = {
      {four_bar_model(2), 0, NAN, 0.01},
      {make_model(extremes::case_of("", chain, 1, {0, 1, 2}).scene), 0.5, 2.5, 0.8}};
  for (const auto& [m, before, failing, after] : walks) {
    const auto f = make_formulation(GetParam(), m), undisturbed = make_formulation(GetParam(), m);
    for (const auto& some : {&*f, &*undisturbed})
      ASSERT_TRUE(some->assemble(0).ok() && some->step(before).ok());
    const std::vector<double> q(f->q().begin(), f->q().end());
    const Summary s = f->step(failing);
    ASSERT_FALSE(s.ok());
    EXPECT_EQ(s.status == Status::not_finite, std::isnan(failing));
    EXPECT_EQ(m.groups[s.group].name, std::isnan(failing) ? "SG-I" : "dyad1/SG-I");
    EXPECT_TRUE(std::ranges::equal(f->q(), q));
    ASSERT_TRUE(f->step(after).ok() && undisturbed->step(after).ok());
    EXPECT_LT(max_difference(f->q(), undisturbed->q()), 1e-10);
  }
}

/// Coupler and rocker are all but stretched, and Newton's method leads far away from there.
TEST(Step, GoesByWayOfTimesBetweenWhereItIsTooLong) {
  const DyadChain chain = extremes::one_dyad(2, std::numbers::pi, 6, 5, 3 + 1e-12);
  const Model m = make_model(extremes::case_of("", chain, 1, {0, 1, 2}).scene);
  const auto f = make_formulation(find_variant("global_automatic_klu"), m);
  ASSERT_TRUE(f->assemble(0).ok());
  for (const double way : {0.01, 0.1, 0.3, -0.3}) {
    ASSERT_TRUE(f->assemble(0).ok());
    if (way < 0) {
      EXPECT_FALSE(f->step(NAN).ok());  // goes on from the time of the last positions
    }
    const Summary s = f->step(way);
    ASSERT_TRUE(s.ok()) << way << ": " << describe(s, m);
    EXPECT_EQ(s.time, way);
    EXPECT_GT(s.sub_steps, 0) << way;
    // The joint stays above the line from pin to pivot, and where the circles meet.
    const int b = m.entities[m.find("crank/B")].first, c = m.entities[m.find("dyad1/C")].first;
    const double x = f->q()[c], y = f->q()[c + 1], bx = f->q()[b], by = f->q()[b + 1];
    EXPECT_NEAR(std::hypot(x - bx, y - by), 5, 1e-11);
    EXPECT_NEAR(std::hypot(x - 6, y), 3, 1e-11);
    EXPECT_GT((6 - bx) * (y - by) + by * (x - bx), 0) << way;
  }
}

/// Generated elimination hands a step over when its pivots fail, and the answer stays right.
TEST(Inlined, FallsBackToPivotingWhereItsOrderFails) {
  const Model m = four_bar_model(1);
  const std::vector<PartDefinition> parts = make_partition(m, Partition::group);
  const Settings settings{.tolerance = 1e-12, .max_iterations = 50};
  const std::vector<double> weights = Magnitudes(m).weights(parts[1]);
  const PartContext context{
      m, parts[1], weights, bind_kernels(m, parts[1]), settings, PartSettings(settings)};
  const Backend& eigen = *find_backend("eigen");
  BoundKernel sabotaged = bind_kernel(m, parts[1]).value();
  Kernel kernel = *sabotaged.kernel;
  kernel.rates = [](const double*, double*, double*, const int*, const double*) { return false; };
  sabotaged.kernel = &kernel;

  const auto at_start = [&] {
    State s = state_at_estimate(m);
    s.qd[m.entities[m.find("crank/B")].first] = 1;
    return s;
  };
  InlinedPart good(bind_kernel(m, parts[1]).value(), weights, PartSettings(settings),
                   make_newton_part(context, eigen), parts[1].unknowns);
  InlinedPart bad(sabotaged, weights, PartSettings(settings), make_newton_part(context, eigen),
                  parts[1].unknowns);
  State expected = at_start(), actual = at_start();
  const PartResult straight = good.solve(expected, expected.q, Level::acceleration),
                   fallen = bad.solve(actual, actual.q, Level::acceleration);
  ASSERT_EQ(straight.status, Status::solved);
  ASSERT_EQ(fallen.status, Status::solved);
  EXPECT_EQ(fallen.iterations, straight.iterations);  // those of what has solved it
  EXPECT_EQ(good.counts().fallbacks, 0);
  EXPECT_EQ(bad.counts().fallbacks, 1);
  EXPECT_EQ(bad.counts().refactorisations, 1);
  EXPECT_LT(max_difference(actual.q, expected.q), 1e-12);
  EXPECT_LT(max_difference(actual.qd, expected.qd), 1e-12);
  EXPECT_LT(max_difference(actual.qdd, expected.qdd), 1e-12);
}

/// At 0.6 s one of the four derivatives of a dyad's lengths vanishes, in each case. In one or
/// another of them it was the first pivot.
TEST(ReusedPivots, AreChosenAnewAndCountedWhereOneVanishes) {
  constexpr double angle = 1.2, crank = 6, pivot = 12;  // the angle is the crank's, then
  const double x = crank * std::cos(angle), y = crank * std::sin(angle);
  const std::array<Mechanism::Vec, 6> joints{{{x, y + 15, 0},
                                              {x, y - 15, 0},
                                              {x + 15, y, 0},
                                              {pivot, 15, 0},
                                              {pivot, -18, 0},
                                              {pivot - 9, 0, 0}}};
  long chosen_anew = 0;
  for (const auto& [jx, jy, jz] : joints) {
    const DyadChain chain{.crank = crank,
                          .start = angle,
                          .dyads = {{{pivot, 0, 0},
                                     std::hypot(jx - x, jy - y),
                                     std::hypot(jx - pivot, jy),
                                     {jx, jy, jz},
                                     std::atan2(jy, jx - pivot)}}};
    const Scene scene =
        extremes::case_of("", std::vector{chain}, {Polynomial{{angle - 0.6, 1}}}, {0, 0.1, 8})
            .scene;
    const Model m = make_model(scene);
    const auto reusing = make_formulation(find_variant("group_automatic_klu"), m),
               anew = make_formulation(find_variant("group_automatic_eigen"), m);
    for (int k = 0; k < scene.grid.instants; ++k) {
      const double t = scene.grid.time(k);
      ASSERT_TRUE(reusing->step(t).ok() && anew->step(t).ok()) << jx << ", " << t;
      for (int i = 0; i < m.coordinates(); ++i)
        EXPECT_NEAR(reusing->qdd()[i], anew->qdd()[i], 1e-10 * (1 + std::abs(anew->qdd()[i])));
    }
    chosen_anew += part_counts(*reusing).refactorisations;
    EXPECT_EQ(part_counts(*anew).refactorisations, 0);
  }
  EXPECT_GT(chosen_anew, 0);
}

/// A dyad folded onto itself: the determinant that the generated code divides by vanishes.
TEST(Inlined, MonitorsRefuseAVanishingPivot) {
  const Model m = four_bar_model(1);
  const BoundKernel dyad = bind_kernel(m, make_partition(m, Partition::group)[1]).value();
  auto [q, qd, qdd] = state_at_estimate(m);
  const auto set = [&](const char* name, double x, double y) {
    q[m.state_index(m.find(name))] = x;
    if (m.entities[m.find(name)].size > 1) q[m.state_index(m.find(name)) + 1] = y;
  };
  set("crank/B", 2, 0);
  set("dyad1/D", 2, 0);
  const auto rates_at = [&](double angle, double nearly) {
    set("dyad1/C", 2 + 6 * std::cos(angle), 6 * std::sin(angle));
    set("dyad1/psi", angle + nearly, 0);
    return dyad.kernel->rates(q.data(), qd.data(), qdd.data(), dyad.inputs.data(),
                              dyad.constants.data());
  };
  EXPECT_FALSE(rates_at(0.3, 0));
  EXPECT_FALSE(rates_at(0.3, 1e-9));
  EXPECT_TRUE(rates_at(0.3, 1));  // no position of the dyad, but one where the pivot is sound
}

}  // namespace
}  // namespace desmo::failure_test
