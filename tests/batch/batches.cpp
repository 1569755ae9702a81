// Parts of one type in the lanes of wide registers: the same as one by one; what is brought into
// lanes and out of them; code for registers that not every processor has.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/base/lane_values.h"
#include "formulations/batch/layout.h"
#include "formulations/equations/lanes.h"
#include "formulations/equations/turned_angle.h"
#include "formulations/id.h"
#include "formulations/prediction/motion_sampler.h"
#include "formulations/prediction/motions_ahead.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/structure/partition.h"
#include "formulations/variants.h"
#include "tests/everything.h"
#include "tests/lanes_here.h"
#include "tests/mechanisms.h"

namespace desmo::lanes_test {
namespace {

constexpr Settings on_lanes{.lanes = 4};

TEST(Lanes, SolveWhatSolvingOneByOneSolves) {
  const auto all = every_motion();
  for (const char* id : {"group_symbolic_explicit", "block_symbolic_explicit"})
    for (const auto& [m, grid] : all)
      for (const int lanes : lanes_here()) {
        const auto one_by_one = make_formulation(find_variant(id), m),
                   at_once = make_formulation(find_variant(id), m, {.lanes = lanes});
        Everything expected(grid.instants), actual(grid.instants);
        const Summary a = one_by_one->run(grid, {}, expected), b = at_once->run(grid, {}, actual);
        ASSERT_TRUE(a.ok() && b.ok()) << m.name;
        EXPECT_LT(b.residual, 1e-10) << m.name;
        expect_same(actual, expected, m.name);
      }
}

TEST(Lanes, WriteWhatIsAskedForAndAllForThoseWhoTakeSteps) {
  const Model m = truck_model(5);
  const TimeGrid grid{0, 0.01, 20};
  const std::vector<int> asked{m.coordinates() - 1, 40, 151};
  for (const int lanes : lanes_here()) {
    const Variant& v = find_variant("group_symbolic_explicit");
    const auto all = make_formulation(v, m, {.guess = Guess::hermite5, .lanes = lanes}),
               some = make_formulation(v, m, {.guess = Guess::hermite5, .lanes = lanes});
    Everything expected(grid.instants), actual(grid.instants);
    ASSERT_TRUE(all->run(grid, {}, expected).ok());
    ASSERT_TRUE(some->run(grid, {Level::acceleration, asked}, actual).ok());
    for (const int i : asked)
      for (int level = 0; level < 3; ++level)
        EXPECT_EQ(actual.all.back()[level * m.coordinates() + i],
                  expected.all.back()[level * m.coordinates() + i]);
    ASSERT_TRUE(all->step(grid.time(20)).ok() && some->step(grid.time(20)).ok());
    EXPECT_TRUE(std::ranges::equal(all->q(), some->q()));
    EXPECT_TRUE(std::ranges::equal(all->qd(), some->qd()));
    EXPECT_TRUE(std::ranges::equal(all->qdd(), some->qdd()));
  }
}

TEST(Lanes, TakeTwinsAndAxlesTogether) {
  const Model m = truck_model(2);
  const auto f = make_formulation(find_variant("group_symbolic_explicit"), m, on_lanes);
  ASSERT_EQ(parts_of(*f).size(), 4u);  // y1, two axles, four levers, four dampers
  int unknowns = 0;
  for (const auto& p : parts_of(*f)) unknowns += static_cast<int>(p.definition.unknowns.size());
  EXPECT_EQ(unknowns, 3 + 2 * (39 + 2 * 19 + 2 * 16));
}

TEST(Lanes, StandInTheIdAndAreRefusedWhereThereIsNoCode) {
  const Variant& v = find_variant("group_symbolic_explicit");
  EXPECT_EQ(id_with(v, on_lanes), "group_symbolic_explicit/lanes:4");
  const Model m = four_bar_model(1);
  EXPECT_THROW(make_formulation(v, m, {.lanes = 5}), std::invalid_argument);
  EXPECT_THROW(make_formulation(find_variant("group_symbolic_inlined"), m, on_lanes),
               std::invalid_argument);
  EXPECT_EQ(unsupported_reason(v, {.lanes = 8}), "");
  if (!has_lanes(8)) {
    EXPECT_NE(unavailable_reason({.lanes = 8}), "");
    EXPECT_THROW(make_formulation(v, m, {.segments = 8}), std::invalid_argument);
  }
}

/// Axles with all that hangs on them are copies of each other: one in each lane, where that takes
/// no more calls than axles, levers and dampers each by themselves.
TEST(Lanes, TakeWholeAxlesAsCopies) {
  const auto parts = [](int axles, int lanes) {
    const Model m = truck_model(axles);
    const auto f = make_formulation(find_variant("group_symbolic_explicit"), m, {.lanes = lanes});
    return parts_of(*f).size();
  };
  EXPECT_EQ(parts(4, 4), 2u);  // y1, and all
  EXPECT_EQ(parts(5, 4), 5u);  // y1, four axles, and of the fifth itself, its levers, its dampers
  EXPECT_EQ(parts(6, 4), 5u);  // four axles; the others would leave lanes empty that twins fill
  EXPECT_EQ(parts(2, 4), 4u);
  if (!has_lanes(8)) GTEST_SKIP() << unavailable_reason({.lanes = 8});
  EXPECT_EQ(parts(5, 8), 2u);
}

TEST(Lanes, AreAsManyAsThereAre) {
  if (!has_lanes(8)) GTEST_SKIP() << unavailable_reason({.lanes = 8});
  const Model m = truck_model(5);
  const auto four = make_formulation(find_variant("group_symbolic_explicit"), m, {.lanes = 4}),
             eight = make_formulation(find_variant("group_symbolic_explicit"), m, {.lanes = 8});
  ASSERT_TRUE(four->assemble(0).ok() && eight->assemble(0).ok());
  expect_to_step_on_alike(*eight, *four, 0);
}

TEST(Elementary, LanesAgreeWithScalars) {
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> uniform(-20, 20);
  const double ulps = 4 * std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 1000; ++i) {
    const Lanes x([&](auto lane) { return i % 10 == 0 && lane == 1 ? 1e7 : uniform(generator); });
    const Lanes y([&](auto) { return uniform(generator); });
    std::array<Lanes, anchor_size> anchors{};
    const Lanes sine = elementary::sin(x), cosine = elementary::cos(x),
                angle = elementary::turned_angle<Lanes>(y, x, 30.0, anchors.data()).angle,
                again = elementary::turned_angle<Lanes>(y, x, angle, anchors.data()).angle;
    for (int l = 0; l < lanes; ++l) {
      const double xl = x[l], yl = y[l];
      std::array<double, anchor_size> anchor{};
      const double alone = elementary::turned_angle<double>(yl, xl, 30.0, anchor.data()).angle;
      EXPECT_NEAR(angle[l], alone, 32 * ulps);
      EXPECT_NEAR(again[l], alone, 32 * ulps);
      EXPECT_EQ(std::isnan(sine[l]), xl == 1e7);
      if (xl == 1e7) continue;
      EXPECT_NEAR(sine[l], std::sin(xl), ulps);
      EXPECT_NEAR(cosine[l], std::cos(xl), ulps);
    }
  }
}

/// What rounding of ωt leaves of a motion whose terms together have amplitude 3 and ω up to 11.
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

/// Each alone, at one time, at several side by side, and at several one behind the other: of the
/// terms, some share a frequency, in one motion and in several.
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

/// Whatever times it is told to expect: those of the grid, others between them, after one was left
/// out, behind the last, and from the first again.
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

/// Any number of them, in any order, to arrays that begin anywhere and end behind the last.
TEST(Lanes, AreTakenApart) {
  constexpr std::size_t most = 37;
  for (const int lanes : lanes_here()) {
    LaneValues from(most * lanes);
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<double>(i);
    for (std::size_t size = 0; size <= most; ++size) {
      std::vector<int> offsets;
      for (std::size_t n = 0; n < size; ++n)
        offsets.push_back(static_cast<int>(n * 5 % most) * lanes);
      std::vector<std::vector<double>> to(lanes);
      std::vector<double*> begins;
      for (int l = 0; l < lanes; ++l) {
        to[l].assign(size + l + 1, -1.0);
        begins.push_back(to[l].data() + l);
      }
      unpack(from.data(), offsets, begins);
      for (int l = 0; l < lanes; ++l) {
        for (std::size_t n = 0; n < size; ++n) ASSERT_EQ(to[l][l + n], offsets[n] + l) << size;
        EXPECT_EQ(to[l].back(), -1.0) << size;
      }
    }
  }
}

/// However many lanes are used, and wherever runs of numbers are interrupted: by one without a
/// place, or with a place in some lanes only.
TEST(Lanes, GoToPlacesOfTheirOwn) {
  constexpr int numbers = 23, apart = 40, untouched = -1;
  for (const int lanes : lanes_here()) {
    LaneValues from(numbers * lanes);
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<double>(i);
    LaneValues negative = from;
    for (double& value : negative) value = -value;
    std::vector<int> which(numbers);
    std::iota(which.begin(), which.end(), 0);
    for (int used = 1; used <= lanes; ++used)
      for (int interrupted = 0; interrupted <= numbers; ++interrupted)
        for (const bool in_all : {true, false}) {
          LanePlaces places(lanes, std::vector<int>(numbers));
          for (int l = 0; l < lanes; ++l)
            for (int n = 0; n < numbers; ++n)
              places[l][n] = n == interrupted && (in_all || l % 2 == 0) ? -1 : l * apart + n;
          std::vector<double> to(lanes * apart, untouched), opposite = to, expected = to,
                                                            expected_opposite = to;
          for (int l = 0; l < used; ++l)
            for (int n = 0; n < numbers; ++n)
              if (const int place = places[l][n]; place >= 0) {
                expected[place] = from[n * lanes + l];
                expected_opposite[place] = -from[n * lanes + l];
              }
          const LaneCopy copies[] = {{from.data(), to.data()}, {negative.data(), opposite.data()}};
          Scatter(which, places, used).scatter(copies);
          ASSERT_EQ(to, expected) << used << " of " << lanes << " lanes, " << interrupted;
          ASSERT_EQ(opposite, expected_opposite);
        }
  }
}

/// Inline functions of others, compiled for processors that not everybody has, must not be what the
/// linker takes for all.
TEST(Lanes, OfWiderRegistersShareNoNames) {
  const std::string objects = DESMO_WIDE_KERNELS;
  if (objects.empty()) GTEST_SKIP() << "this build has no code for them";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
      popen(("nm --extern-only --defined-only " + objects).c_str(), "r"), pclose);
  std::vector<std::string> names;
  std::array<char, 1000> line;
  while (pipe && std::fgets(line.data(), line.size(), pipe.get())) names.emplace_back(line.data());
  std::erase_if(names, [](const std::string& line) {  // names of the files
    return line == "\n" || line.ends_with(":\n");
  });
  ASSERT_EQ(names.size(), 2u) << "the table of each set, and nothing else";
  for (const std::string& name : names) EXPECT_NE(name.find("lane_kernels"), std::string::npos);
}

}  // namespace
}  // namespace desmo::lanes_test
