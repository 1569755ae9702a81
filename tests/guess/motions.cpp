// Values of several motions at once: at one time, at several, and at those of a grid ahead.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "formulations/motion/prediction/motion_sampler.h"
#include "formulations/motion/prediction/motions_ahead.h"

namespace desmo::motions_test {
namespace {

/// Expects values to be those of a motion, except for rounding of ωt. Terms together have an
/// amplitude of 3, and ω up to 11.
void expect_sampled(const Motion& motion, double t, double z, double zd, double zdd) {
  const MotionSample<double> expected = sample(motion, t);
  const auto expect_near = [&](double a, double b, double factor) {
    EXPECT_LE(std::abs(a - b), 1e-14 * (factor * (1 + std::abs(t)) + std::abs(b)))
        << motion.index() << " at " << t;
  };
  expect_near(z, expected.position, 3);
  expect_near(zd, expected.velocity, 3 * 11);
  expect_near(zdd, expected.acceleration, 3 * 11 * 11);
}

/// Motions are sampled at one time, at several side by side, and at several one after the other.
/// Some terms share a frequency, in one motion and in several.
TEST(MotionSampler, GivesWhatEachMotionIs) {
  const Motion motions[] = {HarmonicSum{0.5, {{0.1, 6, 0.3}, {2, -11, 1}, {0.3, 0, 2}}},
                            Polynomial{{1, -2, 0.5, 0.25}},
                            HarmonicSum{-3, {}},
                            make_spline({0, 1, 3, 4, 7}, {0, 1, -1, 2, 0}, SplineEnds::natural),
                            Polynomial{},
                            HarmonicSum{0, {{1, 6, 0}, {1, 6, 1}, {1, 5, 0}}}};
  std::vector<const Motion*> addresses;
  for (const Motion& motion : motions) addresses.push_back(&motion);
  const std::vector<int> places{1, 5, 0, 2, 6, 3};
  constexpr int size = 7, nowhere = 4;
  constexpr double untouched = -77;
  // In one interval of the spline and in several, before and behind; angles beyond reduction.
  const std::array times{0.1, 0.2, 0.3, 0.4, -1.0, 2.5, 8.0, 0.0, 30.0, 1e6, 1e7, 0.7};
  const auto expect_right = [&](int at_once, SampleStrides strides) {
    MotionSampler sampler({addresses, places}, at_once, strides);
    for (std::size_t first = 0; first < times.size(); first += at_once) {
      std::vector<double> z(size * at_once, untouched), zd = z, zdd = z;
      sampler(std::span(times).subspan(first, at_once), z.data(), zd.data(), zdd.data());
      for (int l = 0; l < at_once; ++l) {
        const auto at = [&](int place) { return place * strides.of_place + l * strides.of_time; };
        for (const auto& values : {z, zd, zdd}) EXPECT_EQ(values[at(nowhere)], untouched);
        for (std::size_t i = 0; i < places.size(); ++i) {
          const int k = at(places[i]);
          expect_sampled(motions[i], times[first + l], z[k], zd[k], zdd[k]);
        }
      }
    }
  };
  expect_right(1, {});
  for (const int at_once : {4, 12}) {
    expect_right(at_once, side_by_side(at_once));
    expect_right(at_once, in_rows(size));
  }
  std::vector<const Motion*> alike(8, &motions[0]);  // whole registers of a row
  alike[5] = &motions[5];
  MotionSampler rows(in_order(alike), 4, in_rows(8));
  std::vector<double> z4(4 * 8), zd4 = z4, zdd4 = z4;
  rows(std::span(times).first(4), z4.data(), zd4.data(), zdd4.data());
  for (std::size_t k = 0; k < z4.size(); ++k)
    expect_sampled(*alike[k % 8], times[k / 8], z4[k], zd4[k], zdd4[k]);
  constexpr double t = 1;
  const Motion silent = HarmonicSum{2, {{0, 1e300, 0}}};  // ω² overflows
  double z, zd, zdd;
  MotionSampler({{&silent}, {0}})({&t, 1}, &z, &zd, &zdd);
  EXPECT_EQ(z, 2);
  EXPECT_EQ(zd, 0);
  EXPECT_EQ(zdd, 0);
  MotionSampler(PlacedMotions{})({&t, 1}, nullptr, nullptr, nullptr);  // nothing to write
}

/// Times are those of the grid, which it is told to expect, others between them, after one was left
/// out, after the last, and from the first again.
TEST(MotionsAhead, GiveWhatEachMotionIsAtAnyTime) {
  const Motion motions[] = {HarmonicSum{0.5, {{0.1, 6, 0.3}, {2, -11, 1}}},
                            Polynomial{{1, -2, 0.5}},
                            make_spline({0, 1, 3}, {0, 1, -1}, SplineEnds::natural)};
  const TimeGrid grid{-0.3, 0.1, 21};
  const std::vector<const Motion*> wanted{&motions[0], &motions[0], &motions[2],
                                          &motions[1], &motions[0], &motions[0],
                                          &motions[0], &motions[0], &motions[2]};
  MotionsAhead sampler(wanted);
  const auto expect_at = [&](double t) {
    const MotionRow all = sampler(t);
    for (const std::size_t first : {0, 3}) {
      const MotionRow row = all.from(first);
      for (std::size_t i = first; i < wanted.size(); ++i)
        expect_sampled(*wanted[i], t, row.z[i - first], row.zd[i - first], row.zdd[i - first]);
    }
  };
  expect_at(0.7);
  for (int run = 0; run < 2; ++run) {
    sampler.expect(grid);
    for (int i = 0; i < grid.instants; ++i) {
      expect_at(grid.time(i));
      if (i % 5 == 0) expect_at(grid.time(i));
      if (i % 7 == 0) expect_at(grid.time(i) + 0.03);
      if (run == 1 && i == 9) ++i;
    }
    for (const double t : {grid.time(20), grid.time(21), -1.0}) expect_at(t);
  }
}

}  // namespace
}  // namespace desmo::motions_test
