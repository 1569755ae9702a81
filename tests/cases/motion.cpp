// Motions against closed forms.

#include "cases/mechanism/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>

#include "tests/contains.h"
#include "tests/refusal.h"

namespace desmo::motion_test {
namespace {

using std::numbers::pi;

void expect_near(const MotionSample<double>& found, const MotionSample<double>& expected,
                 const MotionSample<double>& tolerance, double t) {
  EXPECT_NEAR(found.position, expected.position, tolerance.position) << "t = " << t;
  EXPECT_NEAR(found.velocity, expected.velocity, tolerance.velocity) << "t = " << t;
  EXPECT_NEAR(found.acceleration, expected.acceleration, tolerance.acceleration) << "t = " << t;
}

TEST(Polynomial, IsItsClosedForm) {
  const Polynomial m{{3, -2, 0.5, 0.25}};
  for (const double t : {-1.5, 0.0, 0.7, 4.0}) {
    const double z = 3 - 2 * t + 0.5 * t * t + 0.25 * t * t * t;
    expect_near(sample(m, t), {z, -2 + t + 0.75 * t * t, 1 + 1.5 * t}, {1e-13, 1e-13, 1e-13}, t);
  }
  expect_near(sample(Polynomial{}, 2.0), {0, 0, 0}, {}, 2);
  expect_near(sample(Polynomial{{5}}, 2.0), {5, 0, 0}, {}, 2);
  expect_near(sample(Polynomial{{5, 3}}, 2.0), {11, 3, 0}, {}, 2);
  expect_near(sample(Polynomial{{5, 3, 1}}, 2.0), {15, 7, 2}, {}, 2);
}

TEST(HarmonicSum, IsItsClosedForm) {
  const double w = 2 * pi * 1.3;
  const HarmonicSum m{0.5, {{0.05, w, 0.7}, {-0.2, 5, 1.4}}};
  for (const double t : {-0.4, 0.0, 1.1}) {
    const double sine = 0.05 * std::sin(w * t + 0.7), cosine = 0.05 * std::cos(w * t + 0.7),
                 other_sine = -0.2 * std::sin(5 * t + 1.4),
                 other_cosine = -0.2 * std::cos(5 * t + 1.4);
    expect_near(
        sample(m, t),
        {0.5 + sine + other_sine, w * cosine + 5 * other_cosine, -w * w * sine - 25 * other_sine},
        {1e-15, 1e-14, 1e-13}, t);
  }
  expect_near(sample(HarmonicSum{2.5, {}}, 0.37), {2.5, 0, 0}, {}, 0.37);
}

// Unequal intervals and values without a pattern.
const std::vector<double> times{-0.5, 0.1, 0.4, 1.6, 2.0, 2.9};
const std::vector<double> values{1.0, -0.3, 0.8, 0.9, -2.0, 1.0};  // periodic, too
constexpr SplineEnds every_end[] = {SplineEnds::natural, SplineEnds::clamped, SplineEnds::periodic};

/// The piece before (side −1) or after (+1) a knot, at the knot.
MotionSample<double> at_knot(const Spline& s, std::size_t knot, int side) {
  const std::size_t piece = side < 0 ? knot - 1 : knot;
  return sample_polynomial(s.pieces()[piece], s.knots()[knot] - s.knots()[piece]);
}

TEST(Spline, InterpolatesAndIsTwiceContinuouslyDifferentiable) {
  for (const SplineEnds ends : every_end) {
    const Spline s = make_spline(times, values, ends);
    EXPECT_EQ(s.first_time(), times.front());
    EXPECT_EQ(s.last_time(), times.back());
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_NEAR(sample(s, times[i]).position, values[i], 1e-14);
    for (std::size_t i = 1; i + 1 < times.size(); ++i)
      expect_near(at_knot(s, i, -1), at_knot(s, i, +1), {1e-14, 1e-13, 1e-12}, times[i]);
  }
}

TEST(Spline, KeepsTheConditionsAtItsEnds) {
  const Spline natural = make_spline(times, values, SplineEnds::natural);
  EXPECT_NEAR(sample(natural, natural.first_time()).acceleration, 0, 1e-12);
  EXPECT_NEAR(sample(natural, natural.last_time()).acceleration, 0, 1e-12);

  const Spline clamped = make_spline(times, values, SplineEnds::clamped);
  EXPECT_NEAR(sample(clamped, clamped.first_time()).velocity, 0, 1e-13);
  EXPECT_NEAR(sample(clamped, clamped.last_time()).velocity, 0, 1e-13);

  const Spline periodic = make_spline(times, values, SplineEnds::periodic);
  const auto begin = sample(periodic, periodic.first_time());
  const double last = periodic.last_time();
  expect_near(begin, sample(periodic, last), {1e-14, 1e-13, 1e-12}, last);
  EXPECT_GT(std::abs(begin.velocity), 0.1);      // neither clamped
  EXPECT_GT(std::abs(begin.acceleration), 0.1);  // nor natural
}

/// A spline through values of a polynomial is that polynomial, outside of the table too.
void expect_reproduction(const Polynomial& polynomial, SplineEnds ends) {
  std::vector<double> z;
  for (const double t : times) z.push_back(sample(polynomial, t).position);
  const Spline s = make_spline(times, z, ends);
  for (const double t : {-0.8, -0.5, 0.0, 0.33, 1.0, 1.99, 2.7, 3.2})
    expect_near(sample(s, t), sample(polynomial, t), {1e-12, 1e-12, 1e-11}, t);
}

TEST(Spline, ReproducesTheCubicThatMeetsItsEnds) {
  // ż = (t − t₀)(t − tₙ) vanishes at both ends.
  const double t0 = times.front(), tn = times.back();
  expect_reproduction({{0.4, t0 * tn, -(t0 + tn) / 2, 1.0 / 3}}, SplineEnds::clamped);
  // z̈ is linear in t, so that of a natural cubic is 0 everywhere.
  expect_reproduction({{0.4, -1.7}}, SplineEnds::natural);
  expect_reproduction({{0.4}}, SplineEnds::periodic);
}

TEST(Spline, OfTheFewestPoints) {
  const Spline line = make_spline({1, 3}, {0, 4}, SplineEnds::natural);
  expect_near(sample(line, 1.5), {1, 2, 0}, {1e-15, 1e-15, 1e-15}, 1.5);

  // From rest to rest: 3τ² − 2τ³.
  const Spline rise = make_spline({0, 1}, {0, 1}, SplineEnds::clamped);
  const MotionSample<double> quarter{3 * 0.0625 - 2 * 0.015625, 6 * 0.25 - 6 * 0.0625, 3};
  expect_near(sample(rise, 0.25), quarter, {1e-15, 1e-15, 1e-14}, 0.25);

  // Up and down in equal times: by symmetry at rest at the knots.
  const Spline wave = make_spline({0, 1, 2}, {0, 1, 0}, SplineEnds::periodic);
  for (const double t : {0.0, 1.0, 2.0}) EXPECT_NEAR(sample(wave, t).velocity, 0, 1e-14);
  EXPECT_NEAR(sample(wave, 0.5).position, 0.5, 1e-15);
}

TEST(Spline, IsThePieceAfterAKnotFromTheKnotOn) {
  const Spline s = make_spline({0, 1, 2}, {0, 1, 0}, SplineEnds::natural);
  EXPECT_EQ(sample(s, 1.0).position, s.pieces()[1][0].value);
  EXPECT_EQ(sample(s, 1.0).velocity, s.pieces()[1][1].value);
}

/// Returns the message with which make_spline() refuses a table; "accepted": it does not.
std::string refusal(const std::vector<double>& t, const std::vector<double>& z, SplineEnds ends) {
  return desmo::refusal([&] { make_spline(t, z, ends); });
}

TEST(Spline, RefusesTablesThatDefineNone) {
  using enum SplineEnds;
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  EXPECT_CONTAINS(refusal({}, {}, natural), "two points or more");
  EXPECT_CONTAINS(refusal({1}, {1}, clamped), "two points or more");
  EXPECT_CONTAINS(refusal({0, 1}, {1, 1}, periodic), "three points or more");
  EXPECT_CONTAINS(refusal({0, 1, 2}, {1, 1}, natural), "3 times but 2 values");
  EXPECT_CONTAINS(refusal({0, 1, 1, 2}, {1, 2, 3, 4}, natural), "position 2 is not after");
  EXPECT_CONTAINS(refusal({0, 2, 1}, {1, 2, 3}, natural), "position 2 is not after");
  EXPECT_CONTAINS(refusal({0, nan, 1}, {1, 2, 3}, natural),
                  "time that is not finite, at position 1");
  EXPECT_CONTAINS(refusal({0, 1, inf}, {1, 2, 3}, natural),
                  "time that is not finite, at position 2");
  EXPECT_CONTAINS(refusal({0, 1, 2}, {1, 2, -inf}, natural),
                  "value that is not finite, at position 2");
  EXPECT_CONTAINS(refusal({0, 1, 2}, {1, 2, 1.5}, periodic), "value it begins with");
  EXPECT_CONTAINS(refusal({0, 1e-300, 1}, {0, 1e300, 0}, natural), "too steep");
  EXPECT_EQ(refusal({0, 1, 2}, {1, 2, 1}, periodic), "accepted");
}

TEST(Motion, IsAnyOfThemInAnyScalar) {
  const double t = 0.6;
  const Polynomial polynomial{{1, 2, 3}};
  const HarmonicSum harmonic{1, {{2, 3, 4}}};
  const Spline spline = make_spline(times, values, SplineEnds::natural);
  EXPECT_EQ(sample(Motion(polynomial), t).position, sample(polynomial, t).position);
  EXPECT_EQ(sample(Motion(harmonic), t).velocity, sample(harmonic, t).velocity);
  EXPECT_EQ(sample(Motion(spline), t).acceleration, sample(spline, t).acceleration);
  for (const Motion& m : {Motion(polynomial), Motion(harmonic), Motion(spline)}) {
    const auto wide = sample(m, static_cast<long double>(t));
    static_assert(std::is_same_v<decltype(wide.position), long double>);
    EXPECT_NEAR(static_cast<double>(wide.position), sample(m, t).position, 1e-14);
    EXPECT_NEAR(sample(m, static_cast<float>(t)).position, sample(m, t).position, 1e-5);
  }
}

}  // namespace
}  // namespace desmo::motion_test
