// Steps that are followed: long ones in sub-steps, ends on other branches led back, and locks told.

#include "formulations/verification/branch/branch_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "formulations/motion/groupwise/double_solution.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/starts.h"
#include "tests/dead_point.h"

namespace desmo::branch_path_test {
namespace {

/// Follows from one solved instant to another, both refined.
FollowedStep follow(const Model& m, const ReferenceInstant& from, const ReferenceInstant& to,
                    std::vector<double>* end = nullptr) {
  Refinement refinement(m);
  BranchPath path(m);
  EXPECT_TRUE(path.start_at(refined(refinement, from))) << m.name;
  const FollowedStep step = path.follow(refined(refinement, to));
  if (end)
    end->assign(path.present().values.position.begin(), path.present().values.position.end());
  return step;
}

/// Returns how fast the fastest driver turns at most [rad/s]; of a length that oscillates, its
/// phase.
double turning_rate(const Model& m, double begin, double end) {
  double fastest = 0;
  for (const Driver& d : m.drivers) {
    double rate = 0, bend = 0;
    for (int i = 0; i <= 200; ++i) {
      const MotionSample<double> z = sample(d.motion, begin + (end - begin) * i / 200);
      rate = std::max(rate, std::abs(z.velocity));
      bend = std::max(bend, std::abs(z.acceleration));
    }
    const bool angle = m.entities[d.coordinate].kind == EntityKind::angle;
    if (rate > 0) fastest = std::max(fastest, angle ? rate : bend / rate);
  }
  return fastest;
}

/// Steps of an angle [rad] of the fastest driver, from several instants of a scene.
void expect_followed(const Scene& scene, double angle, int max_sub_steps) {
  const Model m = make_model(scene);
  const double begin = scene.grid.start, end = scene.grid.time(scene.grid.instants - 1);
  const double h = std::min(angle / turning_rate(m, begin, end), (end - begin) / 2);
  int most = 0;
  for (int i = 0; i < (DESMO_SANITIZED ? 1 : 6); ++i) {
    const double t = begin + (end - begin - h) * i / 5;
    const auto solved = double_solution(m, std::vector{begin, t, t + h});
    const FollowedStep step = follow(m, solved[1], solved[2]);
    EXPECT_EQ(step.end, PathEnd::same) << m.name << " from " << t << ", step " << h;
    EXPECT_LE(step.sub_steps, max_sub_steps) << m.name << " from " << t << ", step " << h;
    most = std::max(most, step.sub_steps);
  }
  std::cout << m.name << ", " << angle << " rad: at most " << most << " sub-steps\n";
}

TEST(BranchPath, FollowsLongSteps) {
  constexpr double degree = std::numbers::pi / 180;
  for (const Scene& scene : library_scenes()) {
    expect_followed(scene, 1 * degree, 1);
    expect_followed(scene, 5 * degree, 2);
    expect_followed(scene, 20 * degree, 8);
    expect_followed(scene, 1, 16);
  }
}

TEST(BranchPath, GoesFromKnotToKnotAndBack) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = make_spline({0, 1, 1.01, 2}, {0.5, 0.7, 0.71, 0.3}, SplineEnds::natural);
  const auto solved = double_solution(m, std::vector{0.98, 1.03});
  const FollowedStep on = follow(m, solved[0], solved[1]);
  EXPECT_EQ(on.end, PathEnd::same);
  EXPECT_EQ(on.sub_steps, 3);
  BranchPath path(m);
  ASSERT_TRUE(path.start_at({1.03, {solved[1].q, {}, {}}, {}}));
  const FollowedStep step = path.go_to(0.98);
  EXPECT_EQ(step.end, PathEnd::same);
  EXPECT_EQ(step.sub_steps, 3);
  for (int i = 0; i < m.coordinates(); ++i)
    EXPECT_NEAR(path.present().values.position[i], solved[0].q[i], 1e-14);
  EXPECT_EQ(path.go_to(0.98).end, PathEnd::same);
}

/// A step of 0.5 rad that ends d rad before a dead point takes some sub-steps for each decade of d.
TEST(BranchPath, ComesNearADeadPoint) {
  const Model m = locking_four_bar();
  const double locks = dead_point - std::numbers::pi / 3, h = 0.5;
  for (double d = 0.1; d > 1e-8; d *= 0.3) {
    const auto solved = double_solution(m, std::vector{0.0, locks - h, locks - d});
    const FollowedStep step = follow(m, solved[1], solved[2]);
    std::cout << d << ": " << step.sub_steps << " sub-steps, " << step.tests << " tests\n";
    EXPECT_EQ(step.end, PathEnd::same) << d;
    EXPECT_LE(step.sub_steps, 4 * std::log10(h / d) + 12) << d;
  }
}

/// Beyond the dead point there is nothing: the step ends before it, after few tests.
TEST(BranchPath, StopsAtADeadPoint) {
  const Model m = locking_four_bar();
  const double locks = dead_point - std::numbers::pi / 3;
  const auto solved = double_solution(m, std::vector{0.0, locks - 0.1});
  Refinement refinement(m);
  BranchPath path(m);
  ASSERT_TRUE(path.start_at(refined(refinement, solved[1])));
  const FollowedStep step = path.go_to(locks + 0.1);
  std::cout << step.tests << " tests, to " << locks - step.time << " s\n";
  EXPECT_EQ(step.end, PathEnd::stuck);
  EXPECT_LE(step.tests, 200);
  EXPECT_LT(step.time, locks);
  EXPECT_GT(step.time, locks - 1e-9);
  EXPECT_EQ(m.groups[step.group].name, "dyad1/SG-I");
}

/// Ends on other branches, where estimates that are far off lead, and whole turns: none is
/// accepted, and all are led back.
TEST(BranchPath, LeadsOtherEndsBack) {
  int others = 0, led_back = 0;
  std::mt19937 generator(7);
  for (const Scene& scene : library_scenes()) {
    const Model m = make_model(scene);
    const double t = scene.grid.start;
    const std::vector<ReferenceInstant> solved = double_solution(m, std::vector{t, t + 0.01});
    double size = 0;
    for (const double q : m.estimate) size = std::max(size, std::abs(q));
    std::normal_distribution<double> off(0, size);
    for (int i = 0; i < (DESMO_SANITIZED ? 2 : 20); ++i) {
      Model far = m;
      for (double& q : far.estimate) q += off(generator);
      ReferenceInstant other;
      try {
        other = double_solution(far, std::vector{t + 0.01}).front();
      } catch (const std::runtime_error&) {
        continue;
      }
      double difference = 0;
      for (int k = 0; k < m.coordinates(); ++k)
        difference = std::max(difference, std::abs(other.q[k] - solved[1].q[k]));
      if (difference < 1e-6 * size) continue;
      ++others;
      std::vector<double> end;
      const FollowedStep step = follow(m, solved[0], other, &end);
      EXPECT_NE(step.end, PathEnd::same) << m.name;
      if (step.end != PathEnd::other) continue;
      ++led_back;
      for (int k = 0; k < m.coordinates(); ++k) EXPECT_NEAR(end[k], solved[1].q[k], 1e-9 * size);
    }
  }
  EXPECT_EQ(led_back, others);
  EXPECT_GE(others, DESMO_SANITIZED ? 3 : 30);
}

}  // namespace
}  // namespace desmo::branch_path_test
