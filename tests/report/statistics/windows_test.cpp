// The undisturbed time of an analysis, from windows of disturbed ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "report/statistics/statistics.h"

namespace desmo::report::windows_test {
namespace {

/// Analyses of a motion: a microsecond an instant and a nanosecond an update, undisturbed.
Windows windows_of(std::vector<double> updates, std::size_t analyses) {
  Windows s{.updates = std::move(updates)};
  for (std::size_t k = 0; k < s.updates.size(); ++k) s.instants.push_back(120 + k % 2);
  for (std::size_t r = 0; r < analyses; ++r) {
    std::vector<double> sample;
    for (std::size_t k = 0; k < s.updates.size(); ++k)
      sample.push_back(1e-6 * s.instants[k] + 1e-9 * s.updates[k]);
    s.samples.push_back(sample);
  }
  s.least = s.samples.front();
  return s;
}

double truth(const Windows& s) {
  return 1e-6 * std::accumulate(s.instants.begin(), s.instants.end(), 0.0) +
         1e-9 * std::accumulate(s.updates.begin(), s.updates.end(), 0.0);
}

double without_best(const Windows& s) { return *summarise(s.least, s).without_best; }

std::vector<double> varied_updates() {
  std::vector<double> updates;
  for (int k = 0; k < 25; ++k) updates.push_back(20000 + 1500 * (k % 7));
  updates[0] += 3000;  // assembly
  return updates;
}

TEST(UndisturbedTime, IsTheSumWhereNothingDisturbs) {
  const Windows s = windows_of(varied_updates(), 3);
  EXPECT_NEAR(undisturbed(s), truth(s), 1e-12);
  EXPECT_NEAR(without_best(s), truth(s), 1e-12);
}

TEST(UndisturbedTime, IsFoundFromAFewWindowsThatNothingDisturbed) {
  Windows s = windows_of(varied_updates(), 5);
  const double expected = truth(s);
  for (std::size_t r = 0; r < s.samples.size(); ++r)
    for (std::size_t k = 0; k < s.updates.size(); ++k)
      if ((r != 1 && r != 3) || (k % 7 != 0 && k % 7 != 6)) s.samples[r][k] *= 1.3;
  EXPECT_NEAR(undisturbed(s), expected, 1e-3 * expected);
  EXPECT_NEAR(without_best(s), expected, 1e-3 * expected);
}

TEST(UndisturbedTime, OfWindowsAlikeIsThatOfTheLeast) {
  std::vector<double> updates;
  for (int k = 0; k < 25; ++k) updates.push_back(165 * (120 + k % 2));
  Windows s = windows_of(updates, 2);
  const double expected = truth(s);
  for (std::vector<double>& sample : s.samples)
    for (double& seconds : sample) seconds *= 1.3;
  s.samples[1][11] /= 1.3;
  EXPECT_NEAR(undisturbed(s), expected, 1e-12);
  EXPECT_NEAR(without_best(s), 1.3 * expected, 1e-12);  // one witness is none
}

/// Windows with few updates take no longer than windows with many, if only these were
/// undisturbed.
TEST(UndisturbedTime, RisesWithTheUpdates) {
  Windows s = windows_of({10000, 10000, 20000, 20000}, 1);
  for (const std::size_t k : {0, 1}) s.samples[0][k] *= 10;
  const double each = 1e-6 * 121 + 1e-9 * 20000;
  EXPECT_LE(undisturbed(s), 4.1 * each);
  EXPECT_GE(undisturbed(s), truth(s));
}

/// The time grows at most in proportion to the updates. The first window alone has the assembly,
/// and its time is not taken from where it was disturbed.
TEST(UndisturbedTime, GrowsNoFasterThanTheUpdates) {
  std::vector<double> updates;
  for (int k = 0; k < 25; ++k) updates.push_back(k == 0 ? 3e4 : 165 * (120 + k % 2));
  Windows s = windows_of(updates, 2);
  const double expected = truth(s);
  for (std::vector<double>& sample : s.samples) sample[0] *= 1.5;
  EXPECT_NEAR(undisturbed(s), expected, 0.02 * expected);
}

/// Half of the time a core is a third slower, for a while as long as some windows: two runs agree.
TEST(UndisturbedTime, AgreesFromRunToRun) {
  std::mt19937 random(3);
  const auto chance = [&] { return static_cast<double>(random()) / std::mt19937::max(); };
  int apart = 0, conclusive = 0;
  constexpr int runs = 1000;
  for (int run = 0; run < runs; ++run) {
    Windows s = windows_of(varied_updates(), 5);
    const double expected = truth(s);
    std::vector<double> whole;
    for (std::vector<double>& sample : s.samples) {
      bool slow = chance() < 0.5;
      for (double& seconds : sample) {
        if (chance() < 0.1) slow = !slow;
        seconds *= (slow ? 1.33 : 1) * (1 + 0.01 * chance());
      }
      whole.push_back(std::accumulate(sample.begin(), sample.end(), 0.0));
    }
    for (std::size_t k = 0; k < s.least.size(); ++k)
      for (const std::vector<double>& sample : s.samples)
        s.least[k] = std::min(s.least[k], sample[k]);
    const SampleSummary time = summarise(whole, s);
    apart += std::abs(time.value / expected - 1) > 0.015;
    conclusive += !speed_up(time, time).inconclusive();
  }
  EXPECT_LT(apart, runs / 100);
  EXPECT_GT(conclusive, runs * 9 / 10);
}

/// Several threads have one window, the whole motion. Compared with many windows, its samples
/// count as theirs.
TEST(UndisturbedTime, OfOneWindowIsTheLeastAnalysis) {
  const Windows many = windows_of(varied_updates(), 3);
  Windows one{
      .least = {0.5}, .instants = {3000}, .updates = {0}, .samples = {{0.6}, {0.5}, {0.52}}};
  EXPECT_DOUBLE_EQ(undisturbed(one), 0.5);
  EXPECT_DOUBLE_EQ(without_best(one), 0.52);
  const SampleSummary reference = summarise(std::vector{9.0, 8.0}, many),
                      threads = summarise(std::vector{0.6, 0.5, 0.52}, one);
  const SpeedUp s = speed_up(reference, threads);
  EXPECT_DOUBLE_EQ(s.value, reference.value / 0.5);
  EXPECT_DOUBLE_EQ(s.low, reference.value / 0.52);
}

TEST(UndisturbedTime, WithoutUpdatesOnEitherSideSpeedUpsAreRatiosOfSums) {
  const Windows samples = windows_of(varied_updates(), 3);
  Windows least_only{.least = samples.least};
  for (double& seconds : least_only.least) seconds *= 2;
  const double all = std::accumulate(samples.least.begin(), samples.least.end(), 0.0);
  const std::vector<double> whole{all, all}, twice{2 * all, 2 * all};
  EXPECT_NEAR(speed_up(summarise(twice, least_only), summarise(whole, samples)).value, 2, 1e-12);
}

}  // namespace
}  // namespace desmo::report::windows_test
