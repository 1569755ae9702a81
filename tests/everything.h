#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "formulations/formulation.h"
#include "tests/formulated.h"

namespace desmo {

/// An observer that copies q, q̇ and q̈ of every instant.
class Everything : public Observer {
 public:
  explicit Everything(int instants) : all(static_cast<std::size_t>(instants)) {}
  Flow observe(const Instant& i) noexcept override {
    order.push_back(i.index);
    std::vector<double>& values = all.at(i.index);
    values.clear();
    for (const std::span<const double> given : {i.q, i.qd, i.qdd})
      values.insert(values.end(), given.begin(), given.end());
    return Flow::go_on;
  }

  std::vector<std::vector<double>> all;  // by instant: q, q̇, q̈
  std::vector<int> order;                // indices of the instants as they were delivered
};

/// Solves a motion, which succeeds, and returns all that is observed.
inline Everything everything_of(Formulation& f, const TimeGrid& grid) {
  Everything all(grid.instants);
  EXPECT_TRUE(f.run(grid, {}, all).ok()) << f.model().name;
  return all;
}

/// Expects equal positions and accelerations of two formulations at time t and in two more steps.
inline void expect_to_step_on_alike(Formulation& f, Formulation& g, double t) {
  for (int step = 0; step < 3; ++step, t += 0.01) {
    if (step > 0) {
      ASSERT_TRUE(f.step(t).ok() && g.step(t).ok());
    }
    EXPECT_LT(max_difference(f.q(), g.q()), 1e-10) << t;
    EXPECT_LT(max_difference(f.qdd(), g.qdd()), 1e-7) << t;
  }
}

/// Expects the same failure of two formulations, and the same instants before it.
inline void expect_to_fail_alike(Formulation& f, Formulation& g, const TimeGrid& grid) {
  Everything actual(grid.instants), expected(grid.instants);
  const Summary a = f.run(grid, {}, actual), b = g.run(grid, {}, expected);
  ASSERT_FALSE(b.ok());
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.group, b.group);
  EXPECT_EQ(actual.order, expected.order);
}

/// Expects equal values up to 1e-9 of the largest one.
inline void expect_same(const Everything& actual, const Everything& expected,
                        const std::string& name) {
  double size = 1;
  for (const auto& values : expected.all)
    for (const double v : values) size = std::max(size, std::abs(v));
  for (std::size_t i = 0; i < expected.all.size(); ++i) {
    ASSERT_EQ(actual.all[i].size(), expected.all[i].size()) << name << " " << i;
    for (std::size_t k = 0; k < expected.all[i].size(); ++k)
      ASSERT_NEAR(actual.all[i][k], expected.all[i][k], 1e-9 * size)
          << name << " " << i << " " << k;
  }
}

/// Solves a motion with two formulations, and expects the same instants. Returns those of the
/// first.
inline Everything expect_same_motion(Formulation& f, Formulation& g, const TimeGrid& grid,
                                     const std::string& name) {
  Everything actual(grid.instants), expected(grid.instants);
  const Summary a = f.run(grid, {}, actual), b = g.run(grid, {}, expected);
  EXPECT_TRUE(a.ok() && b.ok()) << name;
  EXPECT_EQ(a.instants, grid.instants) << name;
  EXPECT_EQ(a.time, b.time) << name;
  EXPECT_LT(a.residual, 1e-10) << name;
  expect_same(actual, expected, name);
  return actual;
}

}  // namespace desmo
