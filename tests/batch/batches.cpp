// Parts of one type in the lanes of wide registers: the same as one by one; what is brought into
// lanes and out of them; code for registers that not every processor has.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "formulations/base/lane_values.h"
#include "formulations/batch/layout.h"
#include "formulations/equations/lanes.h"
#include "formulations/equations/turned_angle.h"
#include "formulations/motion/internals.h"
#include "tests/everything.h"
#include "tests/lanes_here.h"
#include "tests/mechanisms.h"

namespace desmo::lanes_test {
namespace {

TEST(Lanes, SolveWhatSolvingOneByOneSolves) {
  const auto all = every_motion();
  for (const char* id : {"group_symbolic_explicit", "block_symbolic_explicit"})
    for (const auto& [m, grid] : all)
      for (const int lanes : lanes_here()) {
        const auto one_by_one = formulated(id, m), at_once = formulated(id, m, {.lanes = lanes});
        expect_same_motion(*at_once, *one_by_one, grid, m.name);
      }
}

TEST(Lanes, AreRefusedWhereTheProcessorHasNone) {
  if (has_lanes(8)) GTEST_SKIP() << "this processor has eight";
  EXPECT_NE(unavailable_reason({.lanes = 8}), "");
  const Model m = four_bar_model(1);
  for (const char* id : {"group_symbolic_explicit/lanes:8", "group_symbolic_explicit/segments:8"})
    EXPECT_THROW(formulated(id, m), std::invalid_argument);
}

/// Axles with all that hangs on them are copies of each other: one in each lane, where that takes
/// no more calls than axles, levers and dampers each by themselves.
TEST(Lanes, TakeWholeAxlesAsCopies) {
  const auto parts = [](int axles, int lanes) {
    const Model m = truck_model(axles);
    return parts_of(*formulated("group_symbolic_explicit", m, {.lanes = lanes})).size();
  };
  EXPECT_EQ(parts(4, 4), 2u);  // y1, and all
  EXPECT_EQ(parts(5, 4), 5u);  // y1, four axles, and of the fifth itself, its levers, its dampers
  EXPECT_EQ(parts(6, 4), 5u);  // four axles; the others would leave lanes empty that twins fill
  EXPECT_EQ(parts(2, 4), 4u);
  if (!has_lanes(8)) GTEST_SKIP() << unavailable_reason({.lanes = 8});
  EXPECT_EQ(parts(5, 8), 2u);
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

/// Any number of lanes is used, and runs of numbers are interrupted anywhere: by one without a
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
