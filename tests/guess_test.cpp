// Where Newton–Raphson starts: less work for the same answers, and nothing extrapolated that was
// not solved.

#include "formulations/guess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formulations/variants.h"
#include "tests/every_variant.h"
#include "tests/mechanisms.h"

namespace desmo {
namespace {

constexpr Settings quadratic{.guess = Guess::quadratic};

struct LastInstant final : Sink {
  void accept(const Instant& i) override {
    q.assign(i.q.begin(), i.q.end());
    qdd.assign(i.qdd.begin(), i.qdd.end());
  }
  std::vector<double> q, qdd;
};

TEST(Guess, ExtrapolatesTheCoordinatesGiven) {
  State s{{1, 2, 3}, {10, 20, 30}, {100, 200, 300}};
  extrapolate(Guess::previous, std::vector{0, 1, 2}, 0.1, s);
  EXPECT_EQ(s.q, (std::vector<double>{1, 2, 3}));
  extrapolate(Guess::quadratic, std::vector{0, 2}, 0.1, s);
  EXPECT_DOUBLE_EQ(s.q[0], 1 + 1 + 0.5);
  EXPECT_DOUBLE_EQ(s.q[1], 2);
  EXPECT_DOUBLE_EQ(s.q[2], 3 + 3 + 1.5);
}

TEST(Guess, StandsInTheIdUnlessItIsThePapers) {
  const Variant& v = find_variant("group_symbolic_klu");
  EXPECT_EQ(id_with(v, {}), "group_symbolic_klu");
  EXPECT_EQ(id_with(v, quadratic), "group_symbolic_klu/guess:quadratic");
}

class Guesses : public EveryVariant {};

TEST_P(Guesses, QuadraticSavesIterationsAndChangesNoAnswer) {
  for (const Mechanism& m : {truck_mechanism(1), four_bar_mechanism(3)}) {
    const TimeGrid grid{0, 0.01, 101};
    LastInstant as_before, extrapolated;
    const Summary a = make_formulation(GetParam(), m)->run(grid, {}, as_before);
    const Summary b = make_formulation(GetParam(), m, quadratic)->run(grid, {}, extrapolated);
    ASSERT_TRUE(a.ok() && b.ok()) << m.name;
    EXPECT_LT(b.iterations, 0.75 * static_cast<double>(a.iterations)) << m.name;
    EXPECT_LT(b.residual, quadratic.tolerance);
    for (int i = 0; i < m.coordinates(); ++i) {
      EXPECT_NEAR(as_before.q[i], extrapolated.q[i], 1e-9) << m.name << i;
      EXPECT_NEAR(as_before.qdd[i], extrapolated.qdd[i], 1e-7) << m.name << i;
    }
  }
}

TEST_P(Guesses, QuadraticNeedsAccelerationsOfTheLastInstant) {
  const Mechanism m = truck_mechanism(1);
  const auto f = make_formulation(GetParam(), m, quadratic),
             plain = make_formulation(GetParam(), m);
  for (const auto& each : {f.get(), plain.get()}) {
    ASSERT_TRUE(each->assemble(0).ok());
    ASSERT_TRUE(each->step(0.01, Level::velocity).ok());
  }
  // From here both start from the positions: velocities alone are not extrapolated.
  EXPECT_EQ(f->step(0.02).iterations, plain->step(0.02).iterations);
  EXPECT_LT(f->step(0.03).iterations, plain->step(0.03).iterations);
}

TEST_P(Guesses, QuadraticExtrapolatesNothingAfterAFailure) {
  const Mechanism m = four_bar_mechanism(2);
  const auto f = make_formulation(GetParam(), m, quadratic),
             fresh = make_formulation(GetParam(), m);
  ASSERT_TRUE(f->assemble(0).ok());
  const std::vector<double> q(f->q().begin(), f->q().end());
  ASSERT_FALSE(f->step(std::numeric_limits<double>::quiet_NaN()).ok());
  EXPECT_TRUE(std::ranges::equal(f->q(), q));
  ASSERT_TRUE(fresh->assemble(0).ok());
  EXPECT_EQ(f->step(0.01).iterations, fresh->step(0.01).iterations);
  for (std::size_t i = 0; i < q.size(); ++i) EXPECT_NEAR(f->q()[i], fresh->q()[i], 1e-9);
}

TEST_P(Guesses, QuadraticLeavesPartsAloneWhoseAccelerationsNobodyAsks) {
  const Mechanism m = truck_mechanism(1);
  const std::vector<Level> positions(m.coordinates(), Level::position);
  const auto f = make_formulation(GetParam(), m, quadratic),
             plain = make_formulation(GetParam(), m);
  for (const auto& each : {f.get(), plain.get()}) {
    each->solve_only(positions);
    ASSERT_TRUE(each->assemble(0).ok());
  }
  EXPECT_EQ(f->step(0.01).iterations, plain->step(0.01).iterations);
  EXPECT_TRUE(std::ranges::equal(f->q(), plain->q()));
}

INSTANTIATE_TEST_SUITE_P(Table, Guesses, testing::ValuesIn(variants().begin(), variants().end()),
                         EveryVariant::name);

}  // namespace
}  // namespace desmo
