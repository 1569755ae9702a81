// What cannot be solved ends in a summary that names the group, the constraint and the time.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases/cases.h"
#include "formulations/algebra/backend.h"
#include "formulations/inlined_part.h"
#include "formulations/variants.h"

namespace desmo {
namespace {

class Discard final : public Sink {
 public:
  void accept(const Instant&) override { ++instants; }
  int instants = 0;
};

/// A chain whose second dyad is pulled apart: its ground pivot is out of reach from the start.
Mechanism unreachable() {
  Mechanism m = four_bar(3);
  m.fixed_values[m.entities[m.find("dyad2/D")].first] = 100;
  return m;
}

class EveryVariant : public testing::TestWithParam<const Variant*> {};

TEST_P(EveryVariant, NamesTheGroupThatCannotBeAssembled) {
  const Mechanism m = unreachable();
  const auto f = make_formulation(*GetParam(), m);
  Discard sink;
  const Summary s = f->run(time_grid(1, 0.01), {}, sink);
  ASSERT_FALSE(s.ok());
  EXPECT_EQ(sink.instants, 0);
  EXPECT_EQ(s.time, 0);
  EXPECT_EQ(m.groups[s.group].name, "dyad2");
  EXPECT_TRUE(m.constraints[s.constraint].name.starts_with("dyad2")) << s.constraint;
  EXPECT_NE(describe(s, m).find("'dyad2'"), std::string::npos) << describe(s, m);
}

/// The crank grows too long for the loop to close as it turns: reach ends at a known instant.
TEST_P(EveryVariant, NamesTheInstantOfALockUp) {
  Mechanism m = four_bar(1);
  for (Constraint& c : m.constraints)
    if (c.name == "dyad1 coupler") c.constants[0] = 3 * 3;  // 2 + 3 + 6 spans the pivots, not all
  m.estimate[m.entities[m.find("dyad1/C")].first] = 1.5;
  m.estimate[m.entities[m.find("dyad1/C")].first + 1] = 4;
  // Coupler 3, rocker 6: B may be from 3 to 9 away from D, and 6 − 2 … 6 + 2 is within reach …
  m.fixed_values[m.entities[m.find("dyad1/D")].first] = 8;  // … until ‖D − B‖ = 9.
  // ‖(8, 0) − 2 (cos θ, sin θ)‖² = 81 at cos θ = (68 − 81) / 32, past π/3.
  const double lock = std::acos(-13.0 / 32) - std::acos(0.5);
  const auto f = make_formulation(*GetParam(), m);
  Discard sink;
  const Summary s = f->run(time_grid(3, 0.01), {}, sink);
  ASSERT_FALSE(s.ok());
  EXPECT_EQ(m.groups[s.group].name, "dyad1");
  EXPECT_NEAR(s.time, lock, 0.011) << describe(s, m);
  EXPECT_EQ(sink.instants, static_cast<int>(std::lround(s.time / 0.01)));
}

TEST_P(EveryVariant, CallsWhatIsNotFiniteByItsName) {
  Mechanism m = four_bar(2);
  m.estimate[m.entities[m.find("dyad2/C")].first] = std::numeric_limits<double>::quiet_NaN();
  const Summary s = make_formulation(*GetParam(), m)->assemble(0);
  EXPECT_EQ(s.status, Status::not_finite);
  EXPECT_EQ(m.groups[s.group].name, "dyad2");
}

TEST_P(EveryVariant, AssemblesAgainAfterAFailure) {
  Mechanism m = four_bar(2);
  const auto f = make_formulation(*GetParam(), m);
  ASSERT_TRUE(f->assemble(0).ok());
  const std::vector<double> q(f->q().begin(), f->q().end());
  f->step(1e9);  // wherever that leads
  ASSERT_TRUE(f->assemble(0).ok());
  for (std::size_t i = 0; i < q.size(); ++i) EXPECT_NEAR(f->q()[i], q[i], 1e-12);
}

std::vector<const Variant*> all_variants() {
  std::vector<const Variant*> result;
  for (const Variant& v : variants()) result.push_back(&v);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryVariant, testing::ValuesIn(all_variants()),
                         [](const auto& info) { return info.param->id; });

/// Generated elimination hands a step over when its pivots fail, and the answer stays right.
TEST(Inlined, FallsBackToPivotingWhereItsOrderFails) {
  const Mechanism m = four_bar(1);
  const std::vector<PartDefinition> parts = make_partition(m, Partition::group);
  const PartContext context{m, parts[1], Evaluation::symbolic, 1e-12, 50};
  const Backend* eigen = nullptr;
  for (const Backend* b : backends())
    if (b->name == "eigen") eigen = b;
  BoundKernel sabotaged = bind_kernel(m, 1);
  Kernel kernel = *sabotaged.kernel;
  kernel.rates = [](const double*, double*, double*, const int*, const double*) { return false; };
  sabotaged.kernel = &kernel;

  const auto at_start = [&] {
    State s;
    s.q = m.estimate;
    s.q.insert(s.q.end(), m.fixed_values.begin(), m.fixed_values.end());
    s.qd.assign(s.q.size(), 0);
    s.qdd.assign(s.q.size(), 0);
    s.qd[m.entities[m.find("crank/B")].first] = 1;
    return s;
  };
  InlinedPart good(bind_kernel(m, 1), 1e-12, 50, eigen->make_part(context), parts[1].unknowns);
  InlinedPart bad(sabotaged, 1e-12, 50, eigen->make_part(context), parts[1].unknowns);
  State expected = at_start(), actual = at_start();
  ASSERT_EQ(good.solve(expected, Level::acceleration).status, Status::converged);
  ASSERT_EQ(bad.solve(actual, Level::acceleration).status, Status::converged);
  EXPECT_EQ(good.fallbacks(), 0);
  EXPECT_EQ(bad.fallbacks(), 1);
  for (std::size_t i = 0; i < expected.q.size(); ++i) {
    EXPECT_NEAR(actual.q[i], expected.q[i], 1e-12);
    EXPECT_NEAR(actual.qd[i], expected.qd[i], 1e-12);
    EXPECT_NEAR(actual.qdd[i], expected.qdd[i], 1e-12);
  }
}

TEST(Inlined, NeedsNoFallbackOnTheCases) {
  for (const Case& c : cases()) {
    const Mechanism m = c.build(2);
    const auto f = make_formulation(find_variant("group_symbolic_inlined"), m);
    Discard sink;
    ASSERT_TRUE(f->run(time_grid(3, 0.01), {}, sink).ok());
    for (const auto& part : f->parts())
      EXPECT_EQ(dynamic_cast<const InlinedPart&>(*part.solver).fallbacks(), 0)
          << m.groups[part.definition.groups.front()].name;
  }
}

}  // namespace
}  // namespace desmo
