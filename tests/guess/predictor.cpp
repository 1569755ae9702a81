// Guesses from the rates of the last four instants: exact where theory says so, and left alone
// where those instants are not known.

#include "formulations/motion/prediction/predictor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "formulations/base/part.h"

namespace desmo::predictor_test {
namespace {

constexpr auto solved = Level::acceleration;

/// Walks through instants of two motions of one coordinate each, asking for each where it is
/// expected.
template <class Motion>
struct Walk {
  explicit Walk(Motion m, Guess guess = Guess::adams8)
      : motion(m), predictor(guess, {{0, 1}, {2, 3}}) {}

  /// The guess at t; then t is solved, to this level. Coordinate 1 is none of the predictor's.
  double to(double t, std::optional<Level> level = solved) {
    const StepHistory past{t - last.t, last.t - before.t, last.level, before.level};
    std::vector<double> q = last.state.q;
    if (last.level) predictor(past, last.state, before.state, q.data());
    if (last.level) {
      EXPECT_EQ(q[1], last.state.q[1]);
    }
    before = last;
    last = {t,
            level,
            {{motion(t, 0), 7, -motion(t, 0)},
             {motion(t, 1), 7, -motion(t, 1)},
             {motion(t, 2), 7, -motion(t, 2)}}};
    if (before.level) {
      EXPECT_EQ(q[2], -q[0]);
    }
    return q.empty() ? NAN : q[0];
  }

  struct Solved {
    double t = 0;
    std::optional<Level> level{};
    State state;
  };
  Motion motion;
  Predictor predictor;
  Solved last, before;
};

/// Σ c_i t^i up to a degree; its derivative of some order.
struct Polynomial {
  int degree;
  double operator()(double t, int derivative) const {
    constexpr std::array c{0.3, -2.0, 1.1, 0.7, -0.9, 0.4, -0.3, 0.8, 0.2, 0.6};
    double sum = 0;
    for (int i = degree; i >= derivative; --i) {
      double term = c[i] * std::pow(t, i - derivative);
      for (int d = 0; d < derivative; ++d) term *= i - d;
      sum += term;
    }
    return sum;
  }
};

struct Sine {
  double operator()(double t, int derivative) const { return std::sin(t + derivative * M_PI / 2); }
};

/// It is of the ninth order.
TEST(Predictor, IsExactForPolynomialsUpToDegreeEightWhateverTheSteps) {
  const std::vector<std::vector<double>> ways{{0.1, 0.2, 0.3, 0.4, 0.5},    // even
                                              {0.1, 0.15, 0.3, 0.35, 0.5},  // uneven
                                              {0.5, 0.45, 0.3, 0.2, 0.1},   // backwards
                                              {0.1, 0.2, 0.3, 0.4, 0.35},   // backwards at last
                                              {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.65, 0.7}};
  for (const std::vector<double>& times : ways)
    for (const int degree : {8, 9}) {
      Walk walk(Polynomial{degree});
      double expected = NAN;
      for (const double t : times) expected = walk.to(t);
      const double error = std::abs(expected - walk.motion(times.back(), 0));
      if (degree == 8)
        EXPECT_LT(error, 1e-14) << "to " << times.back();
      else
        EXPECT_GT(error, 1e-12) << "to " << times.back();
    }
}

TEST(Predictor, DoesWithTwoInstantsUntilFourAreKnown) {
  const auto differs_from_quintic = [](auto&& walk_on) {
    Walk far(Sine{}), near(Sine{}, Guess::hermite5);
    return walk_on(far) != walk_on(near);
  };
  for (int known = 1; known <= 5; ++known)
    EXPECT_EQ(differs_from_quintic([&](auto& walk) {
                for (int i = 0; i < known; ++i) walk.to(0.1 * i);
                return walk.to(0.1 * known);
              }),
              known >= 4)
        << known;
  const auto after_three_more = [](auto&& interrupt) {
    return [=](auto& walk) {
      for (int i = 0; i < 6; ++i) walk.to(0.1 * i);
      interrupt(walk);
      for (int i = 7; i < 9; ++i) walk.to(0.1 * i);
      return walk.to(0.9);
    };
  };
  EXPECT_TRUE(differs_from_quintic(after_three_more([](auto& walk) { walk.to(0.6); })));
  EXPECT_FALSE(differs_from_quintic(after_three_more([](auto& walk) {
    walk.to(0.6, Level::velocity);
  }))) << "an instant without accelerations";
  EXPECT_FALSE(differs_from_quintic(after_three_more([](auto& walk) { walk.to(0.6, {}); })))
      << "a failure";
  EXPECT_FALSE(differs_from_quintic(after_three_more([](auto& walk) { walk.to(0.69); })))
      << "two instants too close together";
  EXPECT_FALSE(differs_from_quintic(after_three_more([](auto& walk) { walk.to(0.75); })))
      << "there and back";
}

/// Nothing is left of an error in an earlier position. The quintic magnifies it 31 times.
TEST(Predictor, MagnifiesNoErrorsOfEarlierPositions) {
  const auto shifted = [](Guess guess, int instant) {
    const auto walked = [&](double by) {
      Walk walk(Sine{}, guess);
      for (int i = 0; i < 4; ++i) {
        walk.to(0.1 * i);
        if (i == instant) walk.last.state.q[0] += by, walk.last.state.q[2] -= by;
      }
      return walk.to(0.4);
    };
    return (walked(1e-6) - walked(0)) / 1e-6;
  };
  EXPECT_NEAR(shifted(Guess::adams8, 2), 0, 1e-9);
  EXPECT_NEAR(shifted(Guess::adams8, 3), 1, 1e-9);
  EXPECT_NEAR(shifted(Guess::hermite5, 2), -31, 1e-6);
}

}  // namespace
}  // namespace desmo::predictor_test
