// The start of Newton–Raphson: less work for the same answers, and nothing predicted from what was
// not solved.

#include "formulations/motion/prediction/guess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tests/discard.h"
#include "tests/every_variant.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::guess_test {
namespace {

constexpr Settings quadratic{.guess = Guess::quadratic};
constexpr Guess beyond_previous[] = {Guess::linear, Guess::quadratic, Guess::hermite3,
                                     Guess::hermite5, Guess::adams8};

/// 0.3 − 2t + 1.1t² + 0.7t³ − 0.9t⁴ + 0.4t⁵ − 0.3t⁶, cut to a degree, at an instant.
State polynomial(double t, int degree) {
  constexpr std::array c{0.3, -2.0, 1.1, 0.7, -0.9, 0.4, -0.3};
  State s{{0}, {0}, {0}};
  for (int i = degree; i >= 0; --i) {
    s.qdd[0] = s.qdd[0] * t + 2 * s.qd[0];
    s.qd[0] = s.qd[0] * t + s.q[0];
    s.q[0] = s.q[0] * t + c[i];
  }
  return s;
}

/// Its order is one more.
TEST(Guess, IsExactForPolynomialsUpToItsDegreeWhateverTheSteps) {
  constexpr IndexRange first[] = {{0, 1}};
  const std::pair<Guess, int> degrees[] = {{Guess::previous, 0},
                                           {Guess::linear, 1},
                                           {Guess::quadratic, 2},
                                           {Guess::hermite3, 3},
                                           {Guess::hermite5, 5}};
  for (const auto& [guess, exact] : degrees)
    for (const int degree : {exact, exact + 1})
      for (const double h : {0.1, 0.25, -0.05})
        for (const double before : {0.1, 0.07, 0.3, -0.2}) {
          const StepHistory history{h, before, Level::acceleration, Level::acceleration};
          const State last = polynomial(0.5, degree), earlier = polynomial(0.5 - before, degree);
          double q = NAN;
          Prediction(guess, history)(first, last, earlier, &q);
          const double error = std::abs(q - polynomial(0.5 + h, degree).q[0]);
          EXPECT_TRUE(degree == exact ? error < 1e-12 : error > 1e-10)
              << guess_name(guess) << ", degree " << degree << ": " << error << ", " << h
              << " s after " << before << " s";
        }
}

TEST(Guess, MovesTheCoordinatesGivenAndNoOthers) {
  const State last{{1, 2, 3}, {10, 20, 30}, {100, 200, 300}};
  const StepHistory history{0.1, 0, Level::acceleration};
  std::vector<double> q = {7, 8, 9};
  Prediction(Guess::previous, history)(ranges_of(std::vector{0, 1, 2}), last, last, q.data());
  EXPECT_EQ(q, last.q);
  Prediction(Guess::quadratic, history)(ranges_of(std::vector{0, 2}), last, last, q.data());
  EXPECT_DOUBLE_EQ(q[0], 1 + 1 + 0.5);
  EXPECT_EQ(q[1], 2);
  EXPECT_DOUBLE_EQ(q[2], 3 + 3 + 1.5);
}

TEST(Guess, DoesWithWhatThePastAllows) {
  const auto p = Level::position, v = Level::velocity, a = Level::acceleration;
  const std::optional<Level> unknown;
  const auto best = [](Guess wanted, std::optional<Level> last, std::optional<Level> before,
                       double h = 0.01, double h_before = 0.01) {
    return best_guess(wanted, {h, h_before, last, before});
  };
  EXPECT_EQ(best(Guess::hermite5, a, a), Guess::hermite5);
  EXPECT_EQ(best(Guess::hermite5, a, v), Guess::hermite3);
  EXPECT_EQ(best(Guess::hermite5, v, a), Guess::hermite3);
  EXPECT_EQ(best(Guess::hermite5, a, p), Guess::quadratic);
  EXPECT_EQ(best(Guess::hermite5, a, unknown), Guess::quadratic);
  EXPECT_EQ(best(Guess::hermite5, v, unknown), Guess::linear);
  EXPECT_EQ(best(Guess::hermite5, p, p), Guess::previous);
  EXPECT_EQ(best(Guess::hermite5, unknown, a), Guess::previous);
  EXPECT_EQ(best(Guess::hermite3, a, a), Guess::hermite3);
  EXPECT_EQ(best(Guess::linear, a, a), Guess::linear);
  EXPECT_EQ(best(Guess::previous, a, a), Guess::previous);
  EXPECT_EQ(best(Guess::hermite5, a, a, 0.01, 0.001), Guess::quadratic) << "too close together";
  EXPECT_EQ(best(Guess::hermite5, a, a, 0.01, 0), Guess::quadratic) << "the same instant twice";
  EXPECT_EQ(best(Guess::hermite5, a, a, 0, 0), Guess::quadratic);
  EXPECT_EQ(best_guess(Guess::hermite5, StepHistory{0.01, 0.01, a, a}.up_to(v)), Guess::hermite3);
}

EVERY_VARIANT(Guesses);

TEST_P(Guesses, SaveIterationsAndChangeNoAnswer) {
  for (const Model& m : {truck_model(1), four_bar_model(3)}) {
    const TimeGrid grid{0, 0.01, 101};
    Discard observer;
    const auto as_before = make_formulation(GetParam(), m);
    const Summary a = as_before->run(grid, {}, observer);
    ASSERT_TRUE(a.ok()) << m.name;
    long fewest = a.iterations;
    for (const Guess guess : beyond_previous) {
      const Settings settings{.guess = guess};
      const auto predicted = make_formulation(GetParam(), m, settings);
      const Summary b = predicted->run(grid, {}, observer);
      ASSERT_TRUE(b.ok()) << m.name;
      EXPECT_LE(b.iterations, fewest) << m.name << ", " << guess_name(guess);
      fewest = b.iterations;
      EXPECT_LT(b.residual, settings.tolerance);
      EXPECT_LT(max_difference(as_before->q(), predicted->q()), 1e-9) << m.name;
      EXPECT_LT(max_difference(as_before->qdd(), predicted->qdd()), 1e-7) << m.name;
    }
    if (GetParam().is_explicit() && m.name == "four_bar")  // closed form: it iterates to assemble
      EXPECT_EQ(fewest, a.iterations);
    else
      EXPECT_LT(fewest, 0.55 * static_cast<double>(a.iterations)) << m.name;
  }
}

TEST_P(Guesses, TakeUnequalAndBackwardSteps) {
  const Model m = truck_model(1);
  const auto plain = make_formulation(GetParam(), m);
  for (const Guess guess : beyond_previous) {
    const auto f = make_formulation(GetParam(), m, {.guess = guess});
    long iterations = 0, plain_iterations = 0;
    for (const double t : {0.0, 0.01, 0.012, 0.03, 0.03, 0.028, 0.01, 0.02, 0.0201, 0.05}) {
      const Summary s = f->step(t), p = plain->step(t);
      ASSERT_TRUE(s.ok() && p.ok()) << t;
      iterations += s.iterations;
      plain_iterations += p.iterations;
      EXPECT_LT(max_difference(f->q(), plain->q()), 1e-9) << t;
    }
    // Where closed forms leave little to iterate, a rough guess may save nothing.
    EXPECT_LT(iterations, plain_iterations + GetParam().is_explicit()) << guess_name(guess);
    ASSERT_TRUE(plain->assemble(0).ok());
  }
}

TEST_P(Guesses, DoWithVelocitiesWhereTheLastInstantHadNoMore) {
  const Model m = truck_model(1);
  const auto f = make_formulation(GetParam(), m, quadratic),
             straight = make_formulation(GetParam(), m, {.guess = Guess::linear});
  for (const auto& each : {f.get(), straight.get()}) {
    ASSERT_TRUE(each->assemble(0, Level::velocity).ok());
    ASSERT_TRUE(each->step(0.01, Level::velocity).ok());
    ASSERT_TRUE(each->step(0.02).ok());
  }
  EXPECT_TRUE(std::ranges::equal(f->q(), straight->q()));
  EXPECT_LE(f->step(0.03).iterations, straight->step(0.03).iterations);
  EXPECT_FALSE(std::ranges::equal(f->q(), straight->q()));
}

TEST_P(Guesses, PredictFromNothingAfterAFailure) {
  const Model m = four_bar_model(2);
  const auto f = make_formulation(GetParam(), m, {.guess = Guess::hermite5}),
             fresh = make_formulation(GetParam(), m);
  ASSERT_TRUE(f->assemble(0).ok());
  const std::vector<double> q(f->q().begin(), f->q().end());
  ASSERT_FALSE(f->step(std::numeric_limits<double>::quiet_NaN()).ok());
  EXPECT_TRUE(std::ranges::equal(f->q(), q));
  ASSERT_TRUE(fresh->assemble(0).ok());
  EXPECT_EQ(f->step(0.01).iterations, fresh->step(0.01).iterations);
  EXPECT_LT(max_difference(f->q(), fresh->q()), 1e-9);
}

TEST_P(Guesses, LeavePartsAloneWhoseRatesNobodyAsks) {
  const Model m = truck_model(1);
  const std::vector<Level> positions(m.coordinates(), Level::position);
  const auto f = make_formulation(GetParam(), m, {.guess = Guess::hermite5}),
             plain = make_formulation(GetParam(), m);
  for (const auto& each : {f.get(), plain.get()}) {
    each->solve_only(positions);
    ASSERT_TRUE(each->assemble(0).ok());
  }
  EXPECT_EQ(f->step(0.01).iterations, plain->step(0.01).iterations);
  EXPECT_TRUE(std::ranges::equal(f->q(), plain->q()));
}

}  // namespace
}  // namespace desmo::guess_test
