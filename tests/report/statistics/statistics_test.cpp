#include "report/statistics/statistics.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <numeric>
#include <vector>

#include "report/text/digits.h"

namespace desmo::report::statistics_test {
namespace {

TEST(Statistics, MedianOfOddAndEvenCounts) {
  const SampleSummary odd = summarise(std::vector{5.0, 1.0, 9.0});
  EXPECT_EQ(odd.median, 5);
  EXPECT_EQ(odd.least, 1);
  EXPECT_EQ(odd.largest, 9);
  EXPECT_EQ(odd.half_range(), 4);
  EXPECT_EQ(summarise(std::vector{4.0, 1.0, 2.0, 8.0}).median, 3);
  EXPECT_EQ(summarise(std::vector{7.0}).median, 7);
}

SampleSummary of_windows(std::vector<double> windows) {
  const double all = std::accumulate(windows.begin(), windows.end(), 0.0);
  // The whole is much disturbed.
  return summarise(std::vector{1.5 * all, 2 * all, 3 * all}, {.least = windows});
}

TEST(Statistics, SpeedUpsOfWindowsAreRatiosOfTheirSums) {
  const SpeedUp same = speed_up(of_windows({2, 4, 6}), of_windows({1, 2, 3}));
  EXPECT_DOUBLE_EQ(same.value, 2);
  EXPECT_DOUBLE_EQ(same.low, 2);
  EXPECT_DOUBLE_EQ(same.high, 2);
  EXPECT_DOUBLE_EQ(same.percent, 50);
  EXPECT_TRUE(same.has_interval);
  // By hand: S = 8/4.2, Σ(a - S b)² = 0.108844, t = 3.182: 0.288617 on either side.
  const SpeedUp s = speed_up(of_windows({2, 2, 2, 2}), of_windows({1, 1, 1, 1.2}));
  EXPECT_DOUBLE_EQ(s.value, 8 / 4.2);
  EXPECT_NEAR(s.high - s.value, 0.288617, 1e-6);
  EXPECT_NEAR(s.value - s.low, 0.288617, 1e-6);
}

TEST(Statistics, WhatHasOtherWindowsOrNoneIsComparedByItsMedian) {
  const SampleSummary windows = of_windows({1, 1}), others = of_windows({1, 1, 2});
  const SampleSummary none = summarise(std::vector{4.0, 4.0});
  EXPECT_DOUBLE_EQ(speed_up(none, windows).value, 1);
  EXPECT_DOUBLE_EQ(speed_up(others, windows).value, 2);
  EXPECT_DOUBLE_EQ(speed_up(others, windows).low, 6 / 6.0);
}

TEST(Statistics, ATooWideIntervalIsInconclusive) {
  SpeedUp ratio{.value = 2, .low = 1.92, .high = 2.08, .percent = 50, .has_interval = true};
  EXPECT_NEAR(ratio.half_width(), 0.04, 1e-12);
  EXPECT_FALSE(ratio.inconclusive());
  ratio.high = 2.2;
  EXPECT_TRUE(ratio.inconclusive());
  ratio.has_interval = false;  // one run has no interval, and says that
  EXPECT_FALSE(ratio.inconclusive());
}

TEST(Statistics, MeanOfPercentagesNotPercentageOfTheMean) {
  const SpeedUp half{.value = 2, .low = 1, .high = 3, .percent = 50, .has_interval = true};
  const SpeedUp quarter{.value = 4, .low = 3, .high = 5, .percent = 75, .has_interval = true};
  const SpeedUp both = mean(std::vector{half, quarter});
  EXPECT_DOUBLE_EQ(both.value, 3);
  EXPECT_DOUBLE_EQ(both.low, 2);
  EXPECT_DOUBLE_EQ(both.high, 4);
  EXPECT_DOUBLE_EQ(both.percent, 62.5);
}

// By hand: x = 0, 1, 2 and y = 0, 2, 2 in logarithms. Slope 1, residuals -1/3, 2/3, -1/3, so
// s^2 = 2/3 with one degree of freedom, S_xx = 2 and the half-width 12.706 sqrt(1/3).
TEST(Statistics, SlopeIntervalByHand) {
  const double e = std::exp(1.0);
  const auto slope = fit_slope(std::vector{1.0, e, e * e}, std::vector{1.0, e * e, e * e});
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->value, 1, 1e-12);
  EXPECT_NEAR(slope->high - slope->value, 12.706 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(slope->value - slope->low, 12.706 / std::sqrt(3.0), 1e-9);
}

TEST(Statistics, NoSlopeOfTwoSizes) {
  EXPECT_FALSE(fit_slope(std::vector{1.0, 2.0}, std::vector{1.0, 2.0}));
}

TEST(Digits, OrderOfMagnitude) {
  for (const auto& [value, text] : {std::pair{31.1, "30"},
                                    {0.795, "0.8"},
                                    {0.96, "1"},
                                    {96.0, "100"},
                                    {5.89, "6"},
                                    {0.0, "0"},
                                    {3.14e-13, "3e-13"}})
    EXPECT_EQ(write_order(value), text);
}

TEST(Digits, Significant) {
  for (const auto& [value, digits, text] : {std::tuple{7.1, 4, "7.100"},
                                            {0.607, 4, "0.6070"},
                                            {9.99996, 4, "10.00"},
                                            {12345.6, 4, "12346"},
                                            {0.000012345, 3, "0.0000123"},
                                            {3.14e-13, 2, "3.1e-13"},
                                            {1e9, 2, "1.0e+09"},
                                            {0.0, 3, "0.00"}})
    EXPECT_EQ(write_significant(value, digits), text);
}

TEST(Digits, RatiosAndNegativeZero) {
  EXPECT_EQ(write(0.2934, ratio_digits(0.2934)), "0.29");
  EXPECT_EQ(write(123.4, ratio_digits(123.4)), "123");
  EXPECT_EQ(write(0.01234, ratio_digits(0.01234)), "0.0123");
  EXPECT_EQ(write_fixed(-0.04, 1), "0.0");
  EXPECT_EQ(write_fixed(-0.05001, 1), "-0.1");
  EXPECT_EQ(write_shortest(1e-10), "1e-10");
}

TEST(Digits, ChangesHaveASign) {
  EXPECT_EQ(write_change(2.34), "+2.3");
  EXPECT_EQ(write_change(-0.06), "-0.1");
  for (const double nothing : {0.04, 0.0, -0.04}) EXPECT_EQ(write_change(nothing), "0.0");
  EXPECT_EQ(without_plus(write_change(2.34)), "2.3");
}

TEST(Digits, DoNotFollowTheLocale) {
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no locale with a decimal comma";
  EXPECT_EQ(write_fixed(1.5, 1), "1.5");
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace desmo::report::statistics_test
