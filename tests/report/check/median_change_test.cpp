// The median of logarithms and its bootstrap interval.
#include "report/check/median_change.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace desmo::report::median_change_test {
namespace {

TEST(MedianChange, OfRatiosThatAreAllTheSame) {
  const std::vector<double> base{1, 2, 3, 4, 5}, head{1.1, 2.2, 3.3, 4.4, 5.5};
  const Change c = median_change(head, base);
  EXPECT_NEAR(c.ratio, 1.1, 1e-12);
  EXPECT_NEAR(c.low, 1.1, 1e-12);
  EXPECT_NEAR(c.high, 1.1, 1e-12);
  EXPECT_EQ(c.rounds, 5u);
}

TEST(MedianChange, OutliersDoNotMoveIt) {
  std::vector<double> base(25, 1.0), head(25, 1.0);
  for (int i = 0; i < 8; ++i) head[i] = 3;
  const Change c = median_change(head, base);
  EXPECT_EQ(c.ratio, 1);
  EXPECT_EQ(c.low, 1);
}

TEST(MedianChange, ExchangingTheSidesInvertsIt) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.01);
  std::vector<double> base, head;
  for (int i = 0; i < 25; ++i) base.push_back(std::exp(noise(random))), head.push_back(1.07);
  const Change a = median_change(head, base), b = median_change(base, head);
  EXPECT_NEAR(a.ratio * b.ratio, 1, 1e-12);
  EXPECT_NEAR(a.low * b.high, 1, 1e-12);
  EXPECT_NEAR(a.high * b.low, 1, 1e-12);
}

// Three values have 27 resamples: the middle one is the median of 13, either other one of 7.
TEST(BootstrapMedian, OfThreeValuesByCounting) {
  EXPECT_NEAR(median_at_most(1, 3), 7.0 / 27, 1e-12);
  EXPECT_NEAR(median_at_most(2, 3), 20.0 / 27, 1e-12);
  EXPECT_EQ(median_at_most(3, 3), 1);
}

// 99 of 100 intervals or so hold the true median; 400 samples leave room for chance.
TEST(MedianChange, TheIntervalHoldsTheTrueMedian) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 0.02);
  int held = 0;
  for (int sample = 0; sample < 400; ++sample) {
    std::vector<double> times;
    for (int i = 0; i < 25; ++i) times.push_back(std::exp(0.05 + noise(random)));
    const Change change = median_change(times, std::vector<double>(25, 1));
    held += change.low <= std::exp(0.05) && change.high >= std::exp(0.05);
  }
  EXPECT_GE(held, 388);
}

}  // namespace
}  // namespace desmo::report::median_change_test
